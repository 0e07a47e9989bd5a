# SPDX-License-Identifier: AGPL-3.0-or-later
"""Hopf's function from the fluence, the extrapolation length from its slope deep inside."""

import numpy

from suite.result import last_digit, read_reference
from suite.row import Row


def compare(runs):
    slab = runs["case"]
    flux = slab.wall("zmin", "irradiance_mean")
    found = []
    for row in read_reference("milne_hopf.csv"):
        if row["tau"] == "inf":
            deep = slab.probe("deep")
            slope, at_face = numpy.polyfit([p["z"] for p in deep], [p["fluence"] for p in deep], 1)
            found.append(Row("extrapolation length", at_face / slope, float(row["q"]), 5e-11))
            continue
        tau = float(row["tau"])
        found.append(Row(f"tau + q at {row['tau']}", slab.at((0.5, 0.5, tau))["fluence"] / (3 * flux), tau + float(row["q"]),
                         last_digit(row["q"]), plot="tau + q", curve="fluence / (3 F)", x=tau))
    return found
