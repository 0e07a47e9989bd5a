# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reflected and transmitted part in time, and their amplitude and phase at frequencies; bands are albedos."""

import cmath
import math

from suite import modulated_slab
from suite.result import read_reference
from suite.row import Row

WALLS = {"R": "wall lit", "T": "wall dark"}


def compare(runs):
    found = []
    for name, result in runs.items():
        thickness, *way = name.removeprefix("thickness ").split(", ")
        found += compare_times(result, thickness, ", ".join(way))
        if not way:
            found += compare_modulated(result, thickness)
    return found


def compare_times(result, thickness, way):
    by_steps = way == "by steps"
    # Ends of steps are sums of their lengths.
    values = {(row["name"], row["band"], round(float(row["t"]), 9)): row
              for row in result.table("steps.csv" if by_steps else "times.csv") if row["quantity"] == "incoming"}
    found = []
    times = {round(float(row["t"]), 9) for row in read_reference("slab_switched_on.csv")} & {t for _, _, t in values}
    for row in read_reference("slab_switched_on.csv"):
        computed = values.get((WALLS[row["part"]], row["albedo"], float(row["t"])))
        if row["thickness"] != thickness or computed is None:
            continue
        ending = f", {way}" if way.startswith("by") else ""
        found.append(Row(f"{row['part']}, thickness {thickness}, albedo {row['albedo']}, t {row['t']}{ending}",
                         float(computed["value"]), float(row["value"]), float(row["uncertainty"]),
                         plot=f"thickness {thickness}", curve=f"{row['part']}, albedo {row['albedo']}{ending}", x=float(row["t"])))
    if not found or len(found) < 2 * len(times):
        raise ValueError(f"times.csv of {result.name} has values of {len(found)} references at {len(times)} times")
    return found


def compare_modulated(result, thickness):
    found = []
    for row in result.table("frequency.csv"):
        part = {wall: part for part, wall in WALLS.items()}.get(row["name"])
        if part is None or row["quantity"] != "incoming" or float(row["frequency"]) == 0:
            continue
        rate = 2j * math.pi * float(row["frequency"])
        exact = modulated_slab.parts(rate, float(row["band"]), float(thickness))[part]
        label = f"{part}, thickness {thickness}, albedo {row['band']}, frequency {row['frequency']}"
        lag = -math.degrees(cmath.phase(exact))
        found.append(Row(f"amplitude {label}", float(row["amplitude"]), abs(exact), 1e-9))
        # Phases are known to a turn.
        found.append(Row(f"phase {label}", lag + math.remainder(float(row["phase"]) - lag, 360), lag, 1e-7))
    return found
