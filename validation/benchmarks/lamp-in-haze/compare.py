# SPDX-License-Identifier: AGPL-3.0-or-later
"""Power that arrives at each wall and that is absorbed, in units of the mean wall, beside photons."""

import math

from suite.result import read_reference
from suite.row import Row

WALLS = ("xmin", "xmax", "ymin", "ymax", "zmin", "zmax")


def references():
    """[lamp, g][quantity] value and standard deviation [W] for a lamp of 1 W"""
    known = {}
    for row in read_reference("lamp_in_haze.csv"):
        known.setdefault((row["lamp"], row["g"]), {})[row["quantity"]] = (float(row["value"]), float(row["sd"]))
    return known


def rows_of(name, result, known):
    mean = sum(known[wall][0] for wall in WALLS) / len(WALLS)
    by_photons = name.startswith("photons")
    balance = result.summary["balance"][0]
    values = {wall: result.wall(wall, "incoming") for wall in WALLS} | {"absorbed": balance["absorbed"]}
    errors = {quantity: 0.0 for quantity in values}
    if by_photons:
        errors = {wall: result.wall(wall, "incoming_error") for wall in WALLS}
        errors["absorbed"] = result.summary["photons"]["balance_error"][0]["absorbed"]
    for quantity, (reference, deviation) in known.items():
        yield Row(f"{name}: {quantity}", values[quantity] / mean, reference / mean,
                  math.hypot(deviation, errors[quantity]) / mean)
    if name.startswith("spot-down"):
        for one, other in (("xmin", "xmax"), ("ymin", "ymax")):
            yield Row(f"{name}: {one} less {other}", (values[one] - values[other]) / mean, 0.0)


def compare(runs):
    known = references()
    found = []
    for name, result in runs.items():
        lamp, g = name.removeprefix("photons, ").split(", g ")
        found += rows_of(name, result, known[lamp, g])
    return found
