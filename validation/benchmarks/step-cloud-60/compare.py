# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reflected and transmitted parts of the columns, of what falls on them from above."""

import math

from suite.result import read_reference
from suite.row import Row

# Standard deviation of the consensus and of the own Monte Carlo, for a column.
NOISE = 0.0015


def row(result, part, source, column, reference):
    wall = f"{'top' if part == 'R' else 'bottom'} {column}"
    sunlight = result.wall(f"top {column}", "outgoing")
    return Row(f"{part}, column {column}, {source}", result.wall(wall, "incoming") / sunlight, reference,
               math.hypot(result.wall(wall, "incoming_error") / sunlight, NOISE), plot="step cloud, sun at 60 degrees",
               curve=f"{part}, {source}", x=column)


def compare(runs):
    found = []
    for known in read_reference("i3rc_step_cloud.csv"):
        if known["experiment"] == "2":
            column = int(known["column"])
            found += [row(runs["case"], part, source, column, float(known[key]))
                      for part, source, key in (("R", "consensus", "R"), ("R", "own", "own_R"), ("T", "own", "own_T"))]
    return found
