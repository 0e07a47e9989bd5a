# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence by distance, and the part that escapes; bands are absorption coefficients."""

import math

from suite.result import last_digit, place, read_reference
from suite.row import Row

RUNS = {"absorber_everywhere": "everywhere", "absorbing_sphere_vacuum_outside": "vacuum"}


def compare(runs):
    found = []
    for row in read_reference("sphere_source.csv"):
        band, digits = row["sigma"], last_digit(row["phi"])
        if row["case"] == "absorbing_sphere_escape_probability":
            ball = runs["vacuum"]
            escaped = 1 - ball.region("ball", "absorbed", band) / ball.region("ball", "emitted", band)
            found.append(Row(f"escape probability, sigma {band}", escaped, float(row["phi"]), digits))
            continue
        name = RUNS[row["case"]]
        for point in runs[name].probe("radius", band):
            if math.isclose(math.hypot(*place(point)), float(row["r"]), rel_tol=1e-9, abs_tol=1e-9):
                found.append(Row(f"{name}, sigma {band} at {row['r']}", point["fluence"], float(row["phi"]), digits,
                                 plot="fluence by distance", curve=f"{name}, sigma {band}", x=float(row["r"])))
    return found
