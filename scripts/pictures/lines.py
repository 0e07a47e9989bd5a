# SPDX-License-Identifier: AGPL-3.0-or-later
"""Values at probes as lines, and references beside them where etendue-validate left some."""

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

from pictures.results import read_table  # noqa: E402


def draw_lines(results, options):
    rows = [row for row in read_table(results / "probes.csv") if row["probe"] in options.probe]
    if not rows:
        raise SystemExit(f"draw: no values of probe {', '.join(options.probe)} in {results / 'probes.csv'}")
    known = references(results, options.quantity)
    figure, axes = pyplot.subplots(figsize=(7.5, 5), constrained_layout=True)
    for probe, band in unique((row["probe"], row["band"]) for row in rows):
        of_line = [row for row in rows if (row["probe"], row["band"]) == (probe, band)]
        draw_line(axes, of_line, options, label_of(probe, band, options), known)
    axes.set_xlabel(options.along)
    axes.set_ylabel(options.quantity)
    if options.log:
        axes.set_yscale("log")
    axes.set_title(options.title or "")
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small")
    figure.savefig(options.output, dpi=130)


def draw_line(axes, rows, options, label, known):
    place = [float(row[options.along]) for row in rows]
    line, = axes.plot(place, [float(row[options.quantity]) for row in rows], marker=".", label=label)
    found = [(x, known[key_of(row)]) for x, row in zip(place, rows) if key_of(row) in known]
    if found:
        axes.plot(*zip(*found), linestyle="", marker="o", markersize=8, markerfacecolor="none",
                  color=line.get_color(), label=f"{label}, reference")


def label_of(probe, band, options):
    return " ".join(part for part in (probe if len(options.probe) > 1 else "", options.band_label, band) if part)


def references(results, quantity):
    path = results / "comparison.csv"
    if not path.is_file():
        return {}
    return {key_of(row): float(row["reference"]) for row in read_table(path) if row["column"] == quantity}


def key_of(row):
    return row["probe"], row["index"], row["band"]


def unique(items):
    return list(dict.fromkeys(items))
