# SPDX-License-Identifier: AGPL-3.0-or-later
"""What both forms of the report say, as plain text."""

from suite.result import read_origin

COLUMNS = ["", "computed", "reference", "difference", "relative", "in units of the reference's uncertainty", "allowed", ""]


def cells(judged):
    row = judged.row
    return [row.label, f"{row.value:.6g}", f"{row.reference:.6g}", f"{row.difference:+.2e}",
            "" if row.relative is None else f"{100 * row.relative:+.3g} %", "" if row.sigmas is None else f"{row.sigmas:+.3g}",
            "reported only" if judged.allowed is None else f"{judged.allowed:.2g}", judged.verdict]


def front_cells(outcome):
    """A row of the front page: name, title, verdict, met, worst, its place, seconds."""
    if outcome.benchmark.not_yet:
        return [outcome.benchmark.name, outcome.benchmark.title, "not yet", "", "", outcome.benchmark.not_yet, ""]
    worst = outcome.worst
    where = f"{worst.row.label}: {relative(worst)}" if worst else ""
    return [outcome.benchmark.name, outcome.benchmark.title, outcome.verdict,
            f"{len(outcome.judged) - len(outcome.missed)} of {len(outcome.judged)}",
            f"{100 * worst.share:.0f} %" if worst else "", "; ".join([where, *outcome.faults]) if where else
            "; ".join(outcome.faults), f"{outcome.seconds:.0f}"]


FRONT = ["benchmark", "what", "verdict", "values met", "worst, of what is allowed", "where", "s"]


def relative(judged):
    row = judged.row
    return f"{row.difference:+.2g}" if row.relative is None else f"{100 * row.relative:+.2g} %"


def miss_line(outcome):
    """Why values miss, where the entry knows it; empty where nothing does."""
    reason = outcome.benchmark.missed
    return f"Why it misses: {reason}" if reason and not outcome.passed else ""


def iteration(summary):
    """What the iteration left, of the band that it left most of."""
    return f"iteration to {max(summary['residual']):.0e}, " if summary.get("residual") else ""


def effort(summary):
    """What the method of a run did."""
    if summary["method"] == "photons":
        return f"{summary['photons']['histories']:,.0f} photons"
    if summary["method"] == "radiosity":
        return f"{summary['radiosity']['patches']:,} patches"
    return (f"{summary['directions']:,} directions ({summary['direction_set']['set']}), "
            f"{max(summary['sweeps'])} sweeps")


def run_lines(outcome):
    """What was run, and what it cost."""
    found = []
    for name, result in outcome.results.items():
        if (result.folder / "study.json").is_file():
            found.append(f"{name}: a study, {result.seconds:.0f} s")
            continue
        s = result.summary
        found.append(f"{name}: {s['cells']:,} cells, {len(s['bands'])} band{'s' if len(s['bands']) > 1 else ''}, {effort(s)}, "
                     f"{iteration(s)}{s['seconds']['total']:.1f} s, {s['peak_memory'] / 2 ** 20:.0f} MiB")
    return found


def tolerance_lines(benchmark):
    found = []
    for entry in benchmark.tolerances:
        limits = [f"{100 * entry['relative']:g} % of the reference"] if "relative" in entry else []
        limits += [f"{entry['absolute']:g}"] if "absolute" in entry else []
        found.append((entry["of"], " + ".join(limits) or "reported only", entry["reason"]))
    return found


def origins(benchmark):
    return [(name, read_origin(name)) for name in benchmark.references]


def summary_line(outcomes):
    run = [outcome for outcome in outcomes if not outcome.benchmark.not_yet]
    missed = [outcome.benchmark.name for outcome in run if not outcome.passed]
    values = sum(len(outcome.judged) for outcome in run)
    met = values - sum(len(outcome.missed) for outcome in run)
    return (f"{len(run) - len(missed)} of {len(run)} benchmarks and {met:,} of {values:,} values agree with their references"
            f"{'; missed: ' + ', '.join(missed) if missed else ''}.")


ALLOWED = ("A value passes where its difference from the reference is at most what its tolerance allows and three times the "
           "reference's own uncertainty (one standard deviation, or what its printed digits leave open).")
