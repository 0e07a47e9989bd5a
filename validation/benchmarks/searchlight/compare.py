# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reflected power in rings and in all; rings are walls named by their outer radius."""

import math

from suite.result import read_reference
from suite.row import Row


def compare(runs):
    found = []
    for row in read_reference("searchlight.csv"):
        result = runs[f"{row['w']} {row['g']}"]
        label = f"albedo {row['w']}, g {row['g']}"
        rings = [name for name in result.walls() if name.startswith("to ")]
        if row["r1"] == "inf":
            walls = [*rings, "zmax"]
            error = math.hypot(*(result.wall(name, "incoming_error") for name in walls))
            found.append(Row(f"{label}: all", sum(result.wall(name, "incoming") for name in walls), float(row["R"]),
                             math.hypot(error, float(row["sd"]))))
            continue
        # Some of the reference's rings are several of ours.
        walls = [name for name in rings if float(row["r0"]) < float(name[3:]) <= float(row["r1"])]
        area = sum(result.wall(name, "area") for name in walls)
        error = math.hypot(*(result.wall(name, "incoming_error") for name in walls)) / area
        found.append(Row(f"{label}: {row['r0']} to {row['r1']}", sum(result.wall(name, "incoming") for name in walls) / area,
                         float(row["R"]), math.hypot(error, float(row["sd"])), plot="what comes out, by distance", curve=label,
                         x=(float(row["r0"]) + float(row["r1"])) / 2))
    return found
