# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence at points in an absorbing cube, at the probes and of the field."""

import math

from suite.result import place
from suite.row import Row

SOURCE = (0.0147, 0.0153, 0.0161)
EXTINCTION = 35
LINES = ("line 1", "line 2", "line 3")


def exact(row):
    r = math.dist(place(row), SOURCE)
    return math.exp(-EXTINCTION * r) / (4 * math.pi * r * r)


def errors(rows):
    """Of the field, relative."""
    return [row["fluence_field"] / exact(row) - 1 for row in rows]


def root_mean_square(values):
    return math.sqrt(sum(value**2 for value in values) / len(values))


def compare(runs):
    found, sizes = [], {}
    for name, result in runs.items():
        sizes.setdefault(name.split(", mesh")[0], []).append(result)
        light = result.summary["uncollided"][0]
        found.append(Row(f"absorbed and let out, {name}", light["absorbed"] + light["kept"], 1.0))
    spread, cells = [], []
    for size, results in sizes.items():
        found += [Row(f"probe {i + 1}, {size}", row["fluence"], exact(row))
                  for i, row in enumerate(results[0].probe("inside"))]
        at_points = [error for result in results for error in errors(result.probe("inside"))]
        found.append(Row(f"rms at three points, {size}", root_mean_square(at_points), 0.0))
        spread.append(root_mean_square([error for result in results for line in LINES
                                        for error in errors(result.probe(line))]))
        cells.append(sum(result.summary["cells"] for result in results))
        found.append(Row(f"rms on lines, {size}", spread[-1], 0.0))
    if len(spread) == 2:
        order = 3 * math.log(spread[0] / spread[1]) / math.log(cells[1] / cells[0])
        found.append(Row("order of the field", min(2.0, order), 2.0))
    return found
