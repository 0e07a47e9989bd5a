# SPDX-License-Identifier: AGPL-3.0-or-later
"""The report: figures of every benchmark, then report.html, report.md and values.csv."""

import csv
import dataclasses
import pathlib
import subprocess
import tomllib
from types import SimpleNamespace

from suite import html, markdown, plots
from suite.sketch import draw_sketch


@dataclasses.dataclass
class Figure:
    """`form` is svg or png."""

    name: str
    caption: str
    form: str
    data: bytes


def write(outcomes, options):
    figures = {outcome.benchmark.name: figures_of(outcome) for outcome in outcomes}
    folder = options.output / "pictures"
    folder.mkdir(parents=True, exist_ok=True)
    for found in figures.values():
        for figure in found:
            (folder / f"{figure.name}.{figure.form}").write_bytes(figure.data)
    about = about_run(options)
    (options.output / "report.html").write_text(html.page(outcomes, figures, about), encoding="utf-8")
    (options.output / "report.md").write_text(markdown.page(outcomes, figures, about), encoding="utf-8")
    write_values(outcomes, options.output / "values.csv")


def about_run(options):
    """Version and commit of what was validated."""
    version = subprocess.run([str(options.program), "--version"], check=False, capture_output=True, text=True).stdout.strip()
    here = pathlib.Path(__file__).parent
    commit = subprocess.run(["git", "rev-parse", "--short=10", "HEAD"], check=False, capture_output=True, text=True,
                            cwd=here).stdout.strip()
    return f"{version or 'etendue'}{', commit ' + commit if commit else ''}; {'full' if options.full else 'quick'} set"


def figures_of(outcome):
    benchmark = outcome.benchmark
    found = []
    if not outcome.results:
        return found
    sketched = [result for result in outcome.results.values() if not (result.folder / "study.json").is_file()]
    if sketched:
        chosen = outcome.results.get(benchmark.sketch.get("run", ""), sketched[0])
        sketch = draw_sketch(chosen, benchmark.sketch, mesh_of(benchmark, chosen, "column"), mesh_of(benchmark, chosen, "sheet"))
        if sketch:
            found.append(Figure(f"{benchmark.name}-sketch", "Set-up", "svg", sketch))
    for number, plot in enumerate(benchmark.plots):
        data = plots.draw_plot(outcome, plot)
        if data:
            found.append(Figure(f"{benchmark.name}-plot-{number}", plot["name"], "svg", data))
    for number, picture in enumerate(benchmark.pictures):
        if picture["run"] in outcome.results:
            found.append(field(outcome, picture, number))
    history = plots.draw_histories(outcome)
    if history:
        found.append(Figure(f"{benchmark.name}-iteration", "Iteration: what was left after each sweep", "svg", history))
    for name, result in outcome.results.items():
        if (result.folder / "study.json").is_file():
            found.append(Figure(f"{benchmark.name}-{name}", f"Convergence: {name}", "png", plots.draw_study(result)))
    return found


def mesh_of(benchmark, result, kind):
    """The column or sheet that a run was solved on."""
    return next((run[kind] for run in benchmark.data["run"] if kind in run
                 and "file" in tomllib.loads(result.summary["case"])["mesh"]), None)


def field(outcome, picture, number):
    """The fluence, or another array, on a plane."""
    import io

    from pictures.slice import draw_slice

    buffer = io.BytesIO()
    draw_slice(outcome.results[picture["run"]].folder,
               SimpleNamespace(normal=picture["normal"], at=picture["at"], array=picture.get("array", "fluence"),
                               band=picture.get("band"), log=picture.get("log", False), title=picture.get("title"),
                               output=buffer))
    return Figure(f"{outcome.benchmark.name}-field-{number}", picture.get("title", "Fluence"), "png", buffer.getvalue())


def write_values(outcomes, path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file)
        out.writerow(["benchmark", "label", "value", "reference", "uncertainty", "difference", "allowed", "verdict"])
        for outcome in outcomes:
            for judged in outcome.rows:
                row = judged.row
                out.writerow([outcome.benchmark.name, row.label, f"{row.value:.9g}", f"{row.reference:.9g}",
                              "" if row.uncertainty is None else f"{row.uncertainty:.2g}", f"{row.difference:.3g}",
                              "" if judged.allowed is None else f"{judged.allowed:.3g}", judged.verdict])
