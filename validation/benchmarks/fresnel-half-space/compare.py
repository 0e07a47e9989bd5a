# SPDX-License-Identifier: AGPL-3.0-or-later
"""The part of the light on a smooth surface that comes back from it and from the matter behind."""

from suite.result import last_digit, read_reference
from suite.row import Row

INDEX = 1.5


def compare(runs):
    reference, = read_reference("mcml_half_space.csv")
    surface = ((INDEX - 1) / (INDEX + 1)) ** 2
    rows = []
    for result in runs.values():
        balance = result.summary["balance"][0]
        part = surface + (1 - surface) * balance["outflow"] / balance["inflow"]
        rows.append(Row(f"total reflectance, {result.name}", part, float(reference["published"]), last_digit(reference["published"]),
                        plot="total reflectance", curve="ordinates", x=float(result.name.split()[0])))
    return rows
