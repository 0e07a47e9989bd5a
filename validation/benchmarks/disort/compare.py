# SPDX-License-Identifier: AGPL-3.0-or-later
"""Upward and diffuse downward flux at three depths; bands are the tests."""

import math

from suite.result import read_reference
from suite.row import Row


def compare(runs):
    slab = runs["case"]
    found = []
    for row in read_reference("disort_flux.csv"):
        depth = float(row["depth"])
        point = slab.at((0.5, 0.5, depth), row["case"])
        down = point["irradiance"]
        up = down - point["flux_z"]
        label = f"{row['case']}, depth {depth:g}"
        found.append(Row(f"up, {label}", up, float(row["up_own"]), 5e-6, plot="upward flux", curve=row["case"], x=depth))
        found.append(Row(f"down, {label}", down - math.pi * math.exp(-depth), float(row["dn_own"]), 5e-6,
                         plot="diffuse downward flux", curve=row["case"], x=depth))
    return found
