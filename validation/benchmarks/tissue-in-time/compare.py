# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence in time at distances from a pulse; probes are named by the distance, their points are symmetric twins."""

import math

from suite.result import read_reference
from suite.row import Row


def compare(runs):
    found = []
    for name, result in runs.items():
        values = {(row["name"], float(row["t"])): float(row["value"]) for row in result.table("times.csv")}
        for row in read_reference("pulse_in_tissue.csv"):
            for index in range(3):
                value = values.get((f"probe {row['r']} {index}", float(row["t"])), math.nan)
                if row["g"] != "0.5" or float(row["r"]) > 4 or float(row["t"]) > 40:
                    continue
                found.append(Row(f"{name}, r {row['r']}, t {row['t']}, point {index}", value, float(row["value"]),
                                 float(row["uncertainty"]), plot=f"fluence by time, {name}",
                                 curve=f"r {row['r']}, point {index}", x=float(row["t"])))
    return found
