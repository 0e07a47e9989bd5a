# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reflectance and transmittance of level leaves from their two-stream equations, which are exact."""

import math

from suite.row import Row

LEAVES = {"black": (0.0, 0.0), "red": (0.08, 0.04), "infrared": (0.45, 0.45)}
AREA = 2.0


def compare(runs):
    return rows_of(runs["case"], "") + rows_of(runs["sun"], "sun: ") + rows_of(runs["photons"], "photons: ")


def rows_of(canopy, prefix):
    found = []
    for band, (r, t) in LEAVES.items():
        sent = canopy.wall("sky", "outgoing", band)
        for name, wall, exact in (("R", "sky", reflected(r, t)), ("T", "ground", transmitted(r, t))):
            error = canopy.wall(wall, "incoming_error", band) / sent if prefix == "photons: " else None
            if exact:
                found.append(Row(f"{prefix}{name}, {band}", canopy.wall(wall, "incoming", band) / sent, exact, error))
    return found


def deep(r, t):
    """Reflectance of leaves without end, and the rate at which light falls off in them."""
    rate = math.sqrt((1 - t) ** 2 - r ** 2)
    return ((1 - t - rate) / r if r else 0.0), rate


def reflected(r, t):
    end, rate = deep(r, t)
    through = math.exp(-2 * AREA * rate)
    return end * (1 - through) / (1 - end ** 2 * through)


def transmitted(r, t):
    end, rate = deep(r, t)
    through = math.exp(-AREA * rate)
    return (1 - end ** 2) * through / (1 - (end * through) ** 2)
