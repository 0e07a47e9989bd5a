# SPDX-License-Identifier: AGPL-3.0-or-later
"""Mean fluence of the room and light on its floor, beside those of one run."""

from suite.row import Row

REFERENCE = "turned by 0, order 3"


def compare(runs):
    known = runs[REFERENCE]
    found = []
    for name, room in runs.items():
        if name == REFERENCE:
            continue
        found.append(Row(f"mean fluence, {name}", room.region("air", "fluence_mean"), known.region("air", "fluence_mean")))
        found.append(Row(f"floor, {name}", room.wall("zmin", "irradiance_mean"), known.wall("zmin", "irradiance_mean")))
    return [*found, Row("spread of turns, order 3 over order 1", spread(runs, 3) / spread(runs, 1), 0.0)]


def spread(runs, order):
    """By how much what falls on the floor differs from turn to turn."""
    floors = [room.wall("zmin", "irradiance_mean") for name, room in runs.items() if name.endswith(f"order {order}")]
    return max(floors) - min(floors)
