# SPDX-License-Identifier: AGPL-3.0-or-later
"""Envelopes of error over time, tables and the picture of the comparison with fvDOM."""

import csv
import dataclasses
import math
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

CODES = ("etendue", "fvDOM tetrahedra", "fvDOM hexahedra")


@dataclasses.dataclass
class Row:
    """A run of one code with one mesh and one set of directions; seconds of each turn."""
    scene: str
    code: str
    cells: int
    directions: str
    error: float
    net_error: float
    whole: list
    radiation: list

    def seconds(self, kind):
        """Median of the turns; differences of processes below 5 ms are noise."""
        return max(statistics.median(getattr(self, kind)), 5e-3)


def envelope(rows, kind):
    """Points (seconds, error) of the rows that no other beats in both, by rising time."""
    best = []
    for seconds, error in sorted((row.seconds(kind), row.error) for row in rows):
        if not best or error < best[-1][1]:
            best.append((seconds, error))
    return best


def interpolated(points, at, given):
    """The other coordinate of an envelope where coordinate number `given` is `at`, log-log, and "" inside its range;
    beyond its ends that of the end, and "<=" or "best"."""
    known = [p[given] for p in points]
    other = [p[1 - given] for p in points]
    if given == 1 and at >= known[0]:
        return other[0], "<="
    if given == 0 and at <= known[0]:
        return other[0], "first"
    for k in range(1, len(points)):
        low, high = sorted((known[k - 1], known[k]))
        if low <= at <= high:
            part = math.log(at / known[k - 1]) / math.log(known[k] / known[k - 1])
            return other[k - 1] * (other[k] / other[k - 1]) ** part, ""
    return other[-1], "best"


def by_scene(rows):
    scenes = {}
    for row in rows:
        scenes.setdefault(row.scene, {}).setdefault(row.code, []).append(row)
    return scenes


def equal_error_table(rows, peer, kind):
    """Lines of a table: times of both at the least error of the peer, and at one and a half times as much."""
    lines = [f"| scene | error | {peer}, s | etendue, s | times less |", "|---|---:|---:|---:|---:|"]
    for scene, codes in by_scene(rows).items():
        theirs, ours = envelope(codes[peer], kind), envelope(codes["etendue"], kind)
        for error in (theirs[-1][1], 1.5 * theirs[-1][1]):
            their_seconds, _ = interpolated(theirs, error, 1)
            our_seconds, bound = interpolated(ours, error, 1)
            if bound == "best":
                lines.append(f"| {scene} | {error:.2e} | {their_seconds:.2f} | not reached | |")
                continue
            most, least = ("≤ ", "≥ ") if bound else ("", "")
            lines.append(f"| {scene} | {error:.2e} | {their_seconds:.2f} | {most}{our_seconds:.3f} | "
                         f"{least}{their_seconds / our_seconds:.3g} |")
    return lines


def equal_time_table(rows, kind, seconds):
    """Lines of a table: the least error within a time."""
    lines = ["| scene | " + " | ".join(CODES) + " |", "|---" + "|---:" * len(CODES) + "|"]
    for scene, codes in by_scene(rows).items():
        errors = [interpolated(envelope(codes[code], kind), seconds, 0)[0] for code in CODES]
        lines.append(f"| {scene} | " + " | ".join(f"{error:.2e}" for error in errors) + " |")
    return lines


def run_table(rows, code):
    """Lines of a table: error and seconds of radiation of each mesh and set of directions, a column for each scene."""
    scenes = by_scene(rows)
    lines = ["| cells | directions | " + " | ".join(scenes) + " |", "|---:|---" + "|---:" * len(scenes) + "|"]
    kept = {}
    for scene, codes in scenes.items():
        for row in codes[code]:
            kept.setdefault((row.cells, row.directions), {})[scene] = row
    for (cells, directions), found in kept.items():
        numbers = [f"{found[s].error:.1e}, {found[s].seconds('radiation'):.3f}" if s in found else "" for s in scenes]
        lines.append(f"| {cells:,} | {directions} | " + " | ".join(numbers) + " |")
    return lines


def write_rows(rows, file):
    with open(file, "w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out)
        writer.writerow(["scene", "code", "cells", "directions", "error", "net_error", "whole_seconds",
                         "radiation_seconds", "turns"])
        for row in rows:
            writer.writerow([row.scene, row.code, row.cells, row.directions, f"{row.error:.4e}", f"{row.net_error:.4e}",
                             f"{row.seconds('whole'):.4f}", f"{row.seconds('radiation'):.4f}", len(row.whole)])


def draw(rows, file):
    """Error over the time of radiation, a plot for each scene, with the envelope of each code."""
    scenes = by_scene(rows)
    columns = min(4, len(scenes) + 1)
    lines = -(-(len(scenes) + 1) // columns)
    figure, axes = plt.subplots(lines, columns, figsize=(3.1 * columns, 2.9 * lines), layout="constrained",
                                squeeze=False)
    for plot, (scene, codes) in zip(axes.flat, scenes.items()):
        for color, mark, code in zip(("C3", "C0", "C2"), ("o", "^", "s"), CODES):
            plot.loglog([row.seconds("radiation") for row in codes[code]], [row.error for row in codes[code]], mark,
                        color=color, markersize=4, alpha=0.5)
            plot.loglog(*zip(*envelope(codes[code], "radiation")), "-", color=color, label=code)
        plot.set_title(scene, fontsize=10)
        plot.grid(True, which="major", linewidth=0.3)
    for plot in list(axes.flat)[len(scenes):]:
        plot.axis("off")
    figure.supxlabel("processor time of radiation [s]", fontsize=10)
    figure.supylabel("L2 error of the wall flux", fontsize=10)
    axes.flat[-1].legend(*axes.flat[0].get_legend_handles_labels(), loc="center")
    figure.savefig(file, dpi=110)
