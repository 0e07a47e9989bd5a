# SPDX-License-Identifier: AGPL-3.0-or-later
"""The report: figures of every benchmark, then report.html, report.md and values.csv."""

import csv
import dataclasses
import pathlib
import subprocess
import sys
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
    """A figure that cannot be drawn is missed, the others are not."""
    found = []
    for draw in (sketch, drawn_plots, fields, iteration, convergence) if outcome.results else ():
        try:
            found += draw(outcome)
        except Exception as error:
            print(f"{outcome.benchmark.name}: no {draw.__name__.replace('_', ' ')}: {error!r}", file=sys.stderr)
    return found


def shown_run(outcome):
    """The run that sketches and pictures are of, where none is named; None for studies."""
    runs = [result for result in outcome.results.values() if not (result.folder / "study.json").is_file()]
    return outcome.results.get(outcome.benchmark.sketch.get("run", ""), runs[0]) if runs else None


def sketch(outcome):
    benchmark, run = outcome.benchmark, shown_run(outcome)
    data = run and draw_sketch(run, benchmark.sketch, mesh_of(benchmark, run, "column"), mesh_of(benchmark, run, "sheet"))
    return [Figure(f"{benchmark.name}-sketch", "Set-up", "svg", data)] if data else []


def drawn_plots(outcome):
    drawn = [(number, plot["name"], plots.draw_plot(outcome, plot)) for number, plot in enumerate(outcome.benchmark.plots)]
    return [Figure(f"{outcome.benchmark.name}-plot-{number}", name, "svg", data) for number, name, data in drawn if data]


def fields(outcome):
    """The pictures that the benchmark names, or the fluence in the plane of the sketch."""
    pictures = [picture for picture in outcome.benchmark.pictures if picture["run"] in outcome.results]
    run = shown_run(outcome)
    if not pictures and run and (run.folder / "fields.vtu").is_file():
        plane = {"normal": "y"} | {key: outcome.benchmark.sketch[key] for key in ("normal", "at") if key in outcome.benchmark.sketch}
        if "at" not in plane:
            plane["at"] = middle_of(run.folder, plane["normal"])
        pictures = [{"run": run.name, "title": f"{run.name}: fluence at {plane['normal']} = {plane['at']:.3g}",
                     "log": varies_much(run.folder), **plane}]
    return [field(outcome, picture, number) for number, picture in enumerate(pictures)]


def middle_of(folder, axis):
    """A little beside the middle, where faces of a symmetric mesh may lie."""
    from pictures.results import read_fields

    low, high = read_fields(folder).GetBounds()[2 * "xyz".index(axis):][:2]
    return low + 0.4993 * (high - low)


def varies_much(folder):
    """Whether the fluence of the first band is mostly less than a hundredth of what it is somewhere."""
    import numpy

    from pictures.results import array, read_fields

    values = array(read_fields(folder).GetPointData(), "fluence")[:, 0]
    return bool(values.max() > 100 * numpy.median(values))


def iteration(outcome):
    history = plots.draw_histories(outcome)
    return [Figure(f"{outcome.benchmark.name}-iteration", "Iteration: what was left after each sweep", "svg", history)] if history else []


def convergence(outcome):
    return [Figure(f"{outcome.benchmark.name}-{name}", f"Convergence: {name}", "png", plots.draw_study(result))
            for name, result in outcome.results.items() if (result.folder / "study.json").is_file()]


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
