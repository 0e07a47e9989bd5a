# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence and net flux at points, band by band."""

from suite.result import last_digit, place, read_reference
from suite.row import Row

COLUMNS = (("fluence", "fluence", "phi"), ("flux x", "flux_x", "Jx"), ("flux y", "flux_y", "Jy"), ("flux z", "flux_z", "Jz"))


def compare(runs):
    found = []
    for row in read_reference("manufactured_solutions.csv"):
        result = runs[row["name"]]
        band = f"{row['sigma_t']} {row['sigma_s']} {row['g']}"
        point = result.at(place(row), band)
        for word, column, key in COLUMNS:
            found.append(Row(f"{row['name']}, medium {band}, at {row['x']} {row['y']} {row['z']}: {word}", point[column],
                             float(row[key]), last_digit(row[key])))
    return found
