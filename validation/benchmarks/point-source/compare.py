# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence by distance; bands are albedos."""

import math

from suite.result import last_digit, place, read_reference
from suite.row import Row


def compare(runs):
    found = []
    for row in read_reference("point_source.csv"):
        for point in [point for run in runs.values() if row["c"] in run.bands for point in run.probe("distance", row["c"])]:
            r = math.hypot(*place(point))
            if math.isclose(r, float(row["r"]), rel_tol=1e-6):
                found.append(Row(f"c {row['c']} at {row['r']}", point["fluence"], float(row["phi"]), last_digit(row["phi"]),
                                 plot="fluence by distance", curve=f"c = {row['c']}", x=r))
    return found
