# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence, net flux and the radiance of a direction at points, band by band."""

from suite.field import Field
from suite.result import last_digit, place, read_reference
from suite.row import Row

COLUMNS = (("fluence", "fluence", "phi"), ("flux x", "flux_x", "Jx"), ("flux y", "flux_y", "Jy"), ("flux z", "flux_z", "Jz"))

# By the first component of the direction: what the run that has it is called, and its ordinate.
DIRECTIONS = {"1.000000000": ("", 0), "0.600000000": (" turned", 24), "-0.666666667": (" turned on", 10)}


def compare(runs):
    fields = {}
    found = []
    for row in read_reference("manufactured_solutions.csv"):
        band = f"{row['sigma_t']} {row['sigma_s']} {row['g']}"
        label = f"{row['name']}, medium {band}, at {row['x']} {row['y']} {row['z']}"
        point = runs[row["name"]].at(place(row), band)
        for word, column, key in COLUMNS:
            found.append(Row(f"{label}: {word}", point[column], float(row[key]), last_digit(row[key])))
        suffix, ordinate = DIRECTIONS[row["Ox"]]
        run = row["name"] + suffix
        if run in runs:
            if run not in fields:
                fields[run] = Field(runs[run].folder, f"radiance_{ordinate}")
            found.append(Row(f"{label}: radiance", fields[run].at(place(row), band), float(row["psi"]), last_digit(row["psi"])))
    return found
