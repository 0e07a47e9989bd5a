# SPDX-License-Identifier: AGPL-3.0-or-later
"""Values along lines, computed and reference, with the differences below; errors of a study."""

import io

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

# Okabe and Ito (2008): colours that those see who do not see all; markers and dashes tell the curves apart in print.
COLORS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
MARKERS = "osD^vPX"
DASHES = ["-", "--", "-.", ":"]
SHOWN = 8  # runs that a legend names
matplotlib.rcParams.update({"svg.fonttype": "path", "svg.hashsalt": "etendue", "font.size": 9, "axes.grid": True,
                            "grid.alpha": 0.3})


def save(figure, form="svg"):
    buffer = io.BytesIO()
    figure.savefig(buffer, format=form, dpi=110, metadata={"Date": None} if form == "svg" else None)
    pyplot.close(figure)
    return buffer.getvalue()


def draw_plot(outcome, plot):
    """None where no row belongs to the plot."""
    rows = [judged for judged in outcome.rows if judged.row.plot == plot["name"]]
    if not rows:
        return None
    figure, (above, below) = pyplot.subplots(2, 1, figsize=(6.6, 5), sharex=True, height_ratios=[3, 1.3], layout="constrained")
    curves = list(dict.fromkeys(judged.row.curve for judged in rows))
    for number, curve in enumerate(curves):
        color = COLORS[number % len(COLORS)]
        draw_curve(above, below, [j for j in rows if j.row.curve == curve], number, color)
        for line in outcome.lines:
            if (line.plot, line.curve) == (plot["name"], curve):
                above.plot(line.x, line.y, DASHES[number // len(COLORS) % len(DASHES)], color=color, linewidth=1)
    above.plot([], [], "o", color="0.3", markersize=8, markerfacecolor="none", label="reference (open)")
    scale(above, plot.get("log", ""))
    above.set_ylabel(plot.get("y", ""))
    above.legend(fontsize="x-small", ncols=2 if len(curves) > 5 else 1)
    below.axhspan(-1, 1, color="0.5", alpha=0.15)
    below.set_ylabel("difference /\nallowed")
    below.set_xlabel(plot.get("x", ""))
    return save(figure)


def draw_curve(above, below, rows, number, color):
    marker = MARKERS[number % len(MARKERS)]
    x = [judged.row.x for judged in rows]
    above.plot(x, [j.row.reference for j in rows], marker, color=color, markersize=8, markerfacecolor="none")
    above.plot(x, [j.row.value for j in rows], marker, color=color, markersize=3, label=rows[0].row.curve or "computed")
    shares = [(j.row.x, j.row.difference / j.allowed) for j in rows if j.allowed]
    if shares:
        below.plot(*zip(*shares), marker, color=color, markersize=4)


def scale(axes, logarithmic):
    if "x" in logarithmic:
        axes.set_xscale("log")
    if "y" in logarithmic:
        axes.set_yscale("log")


def draw_histories(outcome):
    """The residual by sweep of each run, of the band that needed most; None where nothing was iterated."""
    curves = {name: slowest(result.history) for name, result in outcome.results.items()}
    curves = {name: curve for name, curve in curves.items() if len(curve) > 2}
    if not curves:
        return None
    figure, axes = pyplot.subplots(figsize=(6.6, 3), layout="constrained")
    for number, (name, curve) in enumerate(curves.items()):
        axes.semilogy(*zip(*curve), DASHES[number // len(COLORS) % len(DASHES)], color=COLORS[number % len(COLORS)],
                      marker=MARKERS[number % len(MARKERS)], markersize=3, linewidth=1,
                      label=name if number < SHOWN or len(curves) == SHOWN + 1 else None)
    if len(curves) > SHOWN + 1:
        axes.plot([], [], " ", label=f"and {len(curves) - SHOWN} more")
    axes.set_xlabel("sweep")
    axes.set_ylabel("residual")
    axes.legend(fontsize="x-small")
    return save(figure)


def slowest(history):
    """(sweep, residual) of the band with most sweeps."""
    bands = {}
    for row in history:
        bands.setdefault(row["band"], []).append((int(row["sweep"]), float(row["residual"])))
    return [point for point in max(bands.values(), key=len, default=[]) if point[1] > 0]


def draw_study(result):
    """Errors against the size that was refined."""
    from types import SimpleNamespace

    from pictures.study import draw_study as draw

    buffer = io.BytesIO()
    draw(result.folder, SimpleNamespace(quantity=None, title=None, output=buffer))
    return buffer.getvalue()
