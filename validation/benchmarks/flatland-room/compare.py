# SPDX-License-Identifier: AGPL-3.0-or-later
"""Irradiance and fluence that the lamp brings, in the clear and in the mist."""

from suite import flatland
from suite.row import Row

ABSORPTION = {"clear": 0.0, "mist": 1.0}


def compare(runs):
    room = runs["case"]
    found = []
    for band, absorption in ABSORPTION.items():
        light = flatland.Lamp(absorption)
        found += [wall(room, name, band, light) for name in flatland.WALLS]
        found += [inside(row, band, light) for row in room.probe("middle", band)]
        found += [on_far_wall(row, band, light) for row in room.probe("far-wall", band)]
    return [row for row in found if row.reference]


def wall(room, name, band, light):
    return Row(f"{name}, {band}", room.wall(name, "irradiance_mean", band), light.mean_irradiance(*flatland.WALLS[name]))


def inside(row, band, light):
    return Row(f"middle {row['x']:.2f}, {band}", row["fluence"], light.fluence((row["x"], row["y"])), plot="across the room",
               curve=band, x=row["x"], run="case", probe="middle", index=row["index"], band=band)


def on_far_wall(row, band, light):
    return Row(f"far-wall {row['x']:.2f}, {band}", row["irradiance"], light.irradiance((row["x"], row["y"]), (0, -1)),
               run="case", probe="far-wall", index=row["index"], band=band, column="irradiance")
