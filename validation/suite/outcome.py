# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs a benchmark and compares what it wrote with its references."""

import csv
import dataclasses
import subprocess
import time

from suite import column, sheet
from suite.result import Result
from suite.row import judge

LIMIT = 3600  # [s], of one run


@dataclasses.dataclass
class Outcome:
    """What became of a benchmark."""

    benchmark: object
    results: dict
    rows: list
    lines: list
    faults: list
    seconds: float

    @property
    def judged(self):
        return [row for row in self.rows if row.allowed is not None]

    @property
    def missed(self):
        return [row for row in self.judged if not row.met]

    @property
    def passed(self):
        chance = self.benchmark.chance
        return (not self.faults and len(self.missed) <= chance["misses"]
                and all(row.share <= chance["share"] for row in self.missed))

    @property
    def worst(self):
        """The row that comes nearest to what is allowed, or exceeds it most."""
        return max(self.judged, key=lambda row: row.share, default=None)

    @property
    def verdict(self):
        return "not yet" if self.benchmark.not_yet else "PASS" if self.passed else "miss"


def check(benchmark, options):
    """Runs what belongs to the set that `options` asks for, unless results are to be kept, and judges it."""
    started = time.monotonic()
    outcome = Outcome(benchmark, {}, [], [], [], 0.0)
    if benchmark.not_yet:
        return outcome
    for run in benchmark.runs(options.full):
        execute(run, outcome, options)
    if len(outcome.results) == len(benchmark.runs(options.full)):
        compare(outcome)
    outcome.seconds = time.monotonic() - started
    return outcome


def execute(run, outcome, options):
    case = (outcome.benchmark.folder / run["case"]).resolve()
    name = run.get("name", case.stem)
    folder = options.output / outcome.benchmark.name / name.replace(", ", "-").replace(" ", "-")
    started = time.monotonic()
    if not options.keep:
        if "column" in run:
            column.write(options.output / outcome.benchmark.name / "column.msh", run["column"], run.get("width", 1.0))
        if "sheet" in run:
            sheet.write(options.output / outcome.benchmark.name / "sheet.msh", run["sheet"])
        for old in ("summary.json", "study.json"):
            (folder / old).unlink(missing_ok=True)
        code = start([str(options.program), *arguments(run, case, folder)])
        if code not in (0, 1):
            outcome.faults.append(f"{name}: the run failed with exit code {code}")
            return
    if not (folder / ("study.json" if "study" in run else "summary.json")).is_file():
        outcome.faults.append(f"{name}: there are no results")
        return
    result = Result(name, folder, time.monotonic() - started)
    outcome.results[name] = result
    if "study" in run:
        outcome.faults += faults_of_study(result)
    else:
        outcome.faults += faults_of(result, run.get("balance", 1e-5))


def arguments(run, case, folder):
    study = run.get("study")
    words = ["study", str(case), "--refine", study["refine"], "--levels", str(study["levels"]), "--no-plot"] if study else ["run", str(case), "--no-estimate"]
    words += ["--output", str(folder), "--progress", "none"]
    for kind in ("column", "sheet"):
        if kind in run:
            words += ["--set", f'mesh.file="{folder.parent.resolve() / kind}.msh"']
    for override in run.get("set", []):
        words += ["--set", override]
    return words


def start(command):
    try:
        return subprocess.run(command, check=False, stdout=subprocess.DEVNULL, timeout=LIMIT).returncode
    except subprocess.TimeoutExpired:
        return f"none after {LIMIT} s"


def faults_of(result, limit):
    """Not converged, or energy that does not close."""
    faults = [] if result.summary["converged"] else [f"{result.name}: not converged"]
    for band, balance in zip(result.bands, result.summary["balance"]):
        if not abs(balance["residual"]) <= limit:
            faults.append(f"{result.name}: balance of band {band}: residual {balance['residual']:.2e}, allowed {limit:g}")
    return faults


def faults_of_study(result):
    """Levels that failed, or did not converge, or whose energy does not close."""
    faults = [f"{result.name}: level {failure['level']} failed: {failure['problem']}" for failure in result.study["failed"]]
    rows = result.study["rows"]
    faults += [f"{result.name}: level {level} not converged" for level in sorted({row["level"] for row in rows if not row["converged"]})]
    faults += [f"{result.name}: balance of level {row['level']}: residual {row['value']:.2e}"
               for row in rows if row["quantity"] == "balance" and not abs(row["value"]) <= 1e-5]
    return faults


def compare(outcome):
    module = outcome.benchmark.module()
    try:
        found = module.compare(outcome.results)
    except Exception as error:  # whatever is amiss with one: the other benchmarks go on
        outcome.faults.append(f"nothing was compared: {error!r}")
        return
    outcome.rows = [judge(row, outcome.benchmark.tolerances) for row in found]
    outcome.lines = module.lines(outcome.results) if hasattr(module, "lines") else []
    if not outcome.judged:
        outcome.faults.append("nothing to compare with")
    for name, result in outcome.results.items():
        write_comparison(result.folder, [row.row for row in outcome.rows if row.row.run == name and row.row.probe])


def write_comparison(folder, rows):
    """References at probes beside the results, where scripts/draw finds them."""
    if not rows:
        return
    with open(folder / "comparison.csv", "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file)
        out.writerow(["label", "probe", "index", "band", "column", "value", "reference"])
        for row in rows:
            out.writerow([row.label, row.probe, row.index, row.band, row.column, f"{row.value:.9g}",
                          f"{row.reference:.9g}"])
