# SPDX-License-Identifier: AGPL-3.0-or-later
"""Mean fluence of blocks, absorption and outflow; powers for all of the lattice and a thickness of 1."""

from suite.result import read_reference
from suite.row import Row

THICKNESS = 0.5


def compare(runs):
    lattice = runs["case"]
    found = []
    for row in read_reference("lattice_blocks.csv"):
        region = f"{row['material']}-{row['i']}-{row['j']}"
        found.append(Row(f"block {row['i']},{row['j']} ({row['material']})", lattice.region(region, "fluence_mean"),
                         float(row["phi_mean"]), float(row["sd"])))
    for row in read_reference("lattice_totals.csv"):
        if row["quantity"].startswith("total absorption"):
            absorbed = sum(lattice.region(region, "absorbed") for region in lattice.regions())
            found.append(Row("total absorption", 2 * absorbed / THICKNESS, float(row["value"]), float(row["sd"])))
        elif row["quantity"].startswith("max block absorption"):
            # One of the two that are mirror images, or both halves of one in the middle.
            of_block = [region for region in lattice.regions() if region.startswith("absorber-2-4")]
            found.append(Row("absorption of block 2,4", sum(lattice.region(r, "absorbed") for r in of_block) / THICKNESS,
                             float(row["value"]), float(row["sd"])))
        elif row["quantity"].startswith("outflow top"):
            found.append(Row("outflow at the top", 2 * lattice.wall("ymax", "incoming") / THICKNESS, float(row["value"]),
                             float(row["sd"])))
    return found
