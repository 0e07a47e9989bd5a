# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence by distance; bands are albedos."""

from suite.result import last_digit, read_reference
from suite.row import Row


def compare(runs):
    return [Row(f"c {row['c']} at {row['x']}", runs["case"].at((5, 5, float(row["x"])), row["c"])["fluence"], float(row["phi"]),
                last_digit(row["phi"]), plot="fluence by distance", curve=f"c = {row['c']}", x=float(row["x"]))
            for row in read_reference("plane_source.csv")]
