# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence by distance; bands are albedos, regions are shells."""

import math

from suite.result import last_digit, read_reference
from suite.row import Row


def compare(runs):
    result = runs["case"]
    return [Row(f"c {row['c']} at {row['r']}", result.region(f"at {row['r']}", "fluence_mean", row["c"]), float(row["phi"]),
                math.hypot(last_digit(row["phi"]), result.region(f"at {row['r']}", "fluence_mean_error", row["c"])),
                plot="fluence by distance", curve=f"c = {row['c']}", x=float(row["r"]))
            for row in read_reference("line_source.csv")]
