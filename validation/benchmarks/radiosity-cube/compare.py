# SPDX-License-Identifier: AGPL-3.0-or-later
"""Mean irradiance of the wall that shines, the one opposite and one beside it."""

from suite.result import read_reference
from suite.row import Row

WALLS = {"emitting": "emitting", "opposite": "opposite", "adjacent": "xmin"}


def compare(runs):
    found = []
    for reference in read_reference("radiosity_cube_6x6.csv"):
        for name, wall in WALLS.items():
            found.append(row(runs, "one patch a wall", name, wall, reference["rho"], reference[f"H_{name}"]))
    for reference in read_reference("radiosity_cube_continuous.csv"):
        name = reference["wall"]
        for run in ("small patches", "quarter with mirrors"):
            found.append(row(runs, run, name, WALLS[name], reference["rho"], reference["H_mean"], float(reference["sd"])))
    return found


def row(runs, run, name, wall, reflectance, reference, deviation=None):
    return Row(f"{run}: {name}, reflectance {reflectance}", runs[run].wall(wall, "irradiance_mean", reflectance),
               float(reference), deviation)
