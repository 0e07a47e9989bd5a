# SPDX-License-Identifier: AGPL-3.0-or-later
"""Flux on the opposite wall and G/4 along the axis; bands are pairs of extinction and albedo."""

from suite.result import read_reference
from suite.row import Row


def compare(runs):
    found = []
    for row in read_reference("square_scattering_hot_wall.csv"):
        band, s = f"{row['beta']} {row['w']}", float(row["s"])
        on_wall = row["where"] == "opposite"
        place = runs["case"].at((s, 0, 0.125) if on_wall else (0.5, s, 0.125), band)
        found.append(Row(f"beta {row['beta']}, albedo {row['w']}: {row['where']} {s:g}",
                         place["irradiance"] if on_wall else place["fluence"] / 4, float(row["value"]), float(row["sd"]),
                         plot="flux on the opposite wall" if on_wall else "G/4 along the axis",
                         curve=f"beta {row['beta']}, albedo {row['w']}", x=s))
    return found
