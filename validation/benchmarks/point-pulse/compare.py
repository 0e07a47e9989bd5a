# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence in time around a lamp that sends a pulse; probes are named by the distance, bands by the albedo."""

from suite.result import read_reference
from suite.row import Row

WAYS = {"by inversion": "times.csv", "by steps": "steps.csv"}


def compare(runs):
    found = []
    for way, table in WAYS.items():
        values = {(row["name"], row["band"], round(float(row["t"]), 9)): float(row["value"])
                  for row in runs["ordinates"].table(table) if row["quantity"] == "fluence"}
        for row in read_reference("point_pulse.csv"):
            for point in (0, 1):
                value = values.get((f"probe {row['r']} {point}", row["albedo"], float(row["t"])))
                # The shell of light that has not collided is at the point itself.
                if value is None or float(row["r"]) == float(row["t"]):
                    continue
                found.append(Row(f"albedo {row['albedo']}, r {row['r']}, t {row['t']}, point {point}, {way}", value,
                                 float(row["value"]), float(row["uncertainty"]), plot="fluence by distance",
                                 curve=f"albedo {row['albedo']}, t {row['t']}, {way}", x=float(row["r"])))
    return found
