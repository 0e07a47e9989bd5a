# SPDX-License-Identifier: AGPL-3.0-or-later
"""Flux on the opposite and on a side wall; bands are absorption coefficients."""

from suite.result import last_digit, read_reference
from suite.row import Row


def compare(runs):
    found = []
    for name, cube in runs.items():
        for row in read_reference("cube_hot_wall.csv"):
            s, y, wall, band = float(row["x_or_z"]), float(row["y"]), row["wall"], row["kappa"]
            point = (s, y, 0.0) if wall == "opposite" else (0.0, y, s)
            on_line = {"plot": f"{wall} wall", "curve": f"{name}, kappa {band}", "x": s} if y == 0.5 else {}
            found.append(Row(f"{name}, kappa {band}, {wall} {s:g}{'' if y == 0.5 else ', corner'}",
                             cube.at(point, band, wall)["irradiance"], float(row["q"]), last_digit(row["q"]), **on_line))
    return found
