# SPDX-License-Identifier: AGPL-3.0-or-later
"""Mean fluence of the quarters."""

from suite.result import read_reference
from suite.row import Row

REGIONS = {"lower_left": ("source",), "lower_right(=upper_left)": ("right", "left"), "upper_right": ("shield",)}


def compare(runs):
    azmy = runs["case"]
    found = []
    for row in read_reference("azmy.csv"):
        regions = REGIONS[row["quadrant"]]
        mean = sum(azmy.region(region, "fluence_mean") for region in regions) / len(regions)
        found.append(Row(f"mean fluence, {row['quadrant'].replace('_', ' ')}", mean, float(row["own_mc"]), float(row["sd"])))
    return found
