# SPDX-License-Identifier: AGPL-3.0-or-later
"""Errors of a study against the size that was refined, beside slopes of whole orders."""

import json

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

MARKERS = "osD^vP*X"


def draw_study(results, options):
    study = json.loads((results / "study.json").read_text())
    rows = [row for row in study["rows"] if row["error"] and row["quantity"] != "balance"]
    wanted = options.quantity or [row["quantity"] for row in rows if row["quantity"].startswith("fluence_")]
    rows = [row for row in rows if not wanted or row["quantity"] in wanted]
    if not rows:
        raise SystemExit(f"draw: no errors of these quantities in {results / 'study.json'}")
    figure, axes = pyplot.subplots(figsize=(7.5, 5), constrained_layout=True)
    for number, (label, points) in enumerate(curves(rows, study["refined"]).items()):
        points.sort()
        axes.loglog(*zip(*points), marker=MARKERS[number % len(MARKERS)], label=label)
    if study["refined"] != "both":
        draw_slopes(axes, study.get("expected_order"))
    axes.set_xlabel("size of the directions, (4π/directions)^(1/2), in flatland 2π/directions"
                    if study["refined"] == "directions" else "cell size h = (volume/cells)^(1/3)")
    axes.set_ylabel("error")
    axes.set_title(options.title or study["title"])
    axes.grid(alpha=0.3, which="both")
    axes.legend(fontsize="small")
    figure.savefig(options.output, dpi=130)


def curves(rows, refined):
    """Points by label. Where both are refined there is a curve over the meshes for each direction set."""
    bands = len({row["band"] for row in rows})
    found = {}
    for row in rows:
        label = row["quantity"] + (f" {row['band']}" if bands > 1 else "")
        if refined == "both":
            label += f", {row['directions']} directions"
        found.setdefault(label, []).append((row["h"] if refined == "both" else row["size"], row["error"]))
    return found


def draw_slopes(axes, expected):
    """Lines of order 1 and 2, or of that of the best approximation, through the upper right corner of the errors."""
    right = max(axes.dataLim.intervalx)
    left = min(axes.dataLim.intervalx)
    top = max(axes.dataLim.intervaly)
    for order, style in zip([expected] if expected else [1, 2], ("--", ":")):
        axes.plot([left, right], [top * (left / right) ** order, top], style, color="0.5", label=f"order {order}")
