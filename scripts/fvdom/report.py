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


def interpolated(points, coordinate, value):
    """Point (seconds, error) of an envelope where a coordinate (0: seconds, 1: error) has a value, and its place.

    The place is "between" points, log-log, or the "first" or "last" point where the value is outside."""
    known = [math.log(point[coordinate]) for point in points]
    at = math.log(value)
    if (at - known[0]) * (1 if coordinate == 0 else -1) <= 0:
        return points[0], "first"
    for before, after, low, high in zip(points, points[1:], known, known[1:]):
        if min(low, high) <= at <= max(low, high):
            part = (at - low) / (high - low)
            return tuple(x * (y / x) ** part for x, y in zip(before, after)), "between"
    return points[-1], "last"


def by_scene(rows):
    scenes = {}
    for row in rows:
        scenes.setdefault(row.scene, {}).setdefault(row.code, []).append(row)
    return scenes


def equal_error_table(rows, peer):
    """Lines of a table: times of both at the least error of the peer, and at one and a half times as much."""
    lines = [f"| scene | error | {peer}: radiation, s | etendue, s | times less | whole process, s | etendue, s "
             "| times less |", "|---" + "|---:" * 7 + "|"]
    for scene, codes in by_scene(rows).items():
        least = min(row.error for row in codes[peer])
        for error in (least, 1.5 * least):
            cells = [part for kind in ("radiation", "whole") for part in _times(codes, peer, kind, error)]
            lines.append(f"| {scene} | {error:.2e} | " + " | ".join(cells) + " |")
    return lines


def _times(codes, peer, kind, error):
    """Seconds of the peer and of etendue at an error, and their ratio; a bound where every run of etendue is better."""
    theirs = interpolated(envelope(codes[peer], kind), 1, error)[0][0]
    (ours, _), place = interpolated(envelope(codes["etendue"], kind), 1, error)
    if place == "last":
        return f"{theirs:.2f}", "not reached", ""
    most, least = ("≤ ", "≥ ") if place == "first" else ("", "")
    return f"{theirs:.2f}", f"{most}{ours:.3f}", f"{least}{theirs / ours:.3g}"


def equal_time_table(rows, times):
    """Lines of a table: errors of all codes after times of radiation."""
    heads = [f"{code}, {seconds:g} s" for seconds in times for code in CODES]
    lines = ["| scene | " + " | ".join(heads) + " |", "|---" + "|---:" * len(heads) + "|"]
    for scene, codes in by_scene(rows).items():
        found = [interpolated(envelope(codes[code], "radiation"), 0, seconds) for seconds in times for code in CODES]
        lines.append(f"| {scene} | " + " | ".join(
            "" if place == "first" else f"{error:.2e}" for (_, error), place in found) + " |")
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


COLUMNS = {"scene": str, "code": str, "cells": int, "directions": str, "error": float, "net_error": float}


def write_rows(rows, file):
    with open(file, "w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out)
        writer.writerow([*COLUMNS, "whole_seconds", "radiation_seconds"])
        for row in rows:
            writer.writerow([row.scene, row.code, row.cells, row.directions, f"{row.error:.4e}", f"{row.net_error:.4e}",
                             f"{row.seconds('whole'):.4f}", f"{row.seconds('radiation'):.4f}"])


def read_rows(file):
    """Rows of an earlier comparison, with the medians of their turns."""
    with open(file, newline="", encoding="utf-8") as lines:
        return [Row(**{name: kind(line[name]) for name, kind in COLUMNS.items()},
                    whole=[float(line["whole_seconds"])], radiation=[float(line["radiation_seconds"])])
                for line in csv.DictReader(lines)]


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
