# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence in time at distances from a plane that sends a pulse; probes are named by the distance, bands by the albedo."""

from suite.result import read_reference
from suite.row import Row


def compare(runs):
    result = runs["photons"]
    values = {(row["name"], row["band"], float(row["t"])): float(row["value"]) for row in result.table("times.csv")
              if row["quantity"] == "fluence"}
    found = []
    for row in read_reference("plane_pulse.csv"):
        value = values.get((f"probe {row['x']} 0", row["albedo"], float(row["t"])))
        # At the front itself the fluence jumps.
        if value is None or float(row["x"]) == float(row["t"]):
            continue
        found.append(Row(f"albedo {row['albedo']}, x {row['x']}, t {row['t']}", value, float(row["value"]),
                         float(row["uncertainty"]), plot="fluence by time",
                         curve=f"albedo {row['albedo']}, x {row['x']}", x=float(row["t"])))
    return found
