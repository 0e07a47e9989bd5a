# SPDX-License-Identifier: AGPL-3.0-or-later
"""The rate of decay from three equally spaced fluences; bands are pairs of albedo and mean cosine."""

import math

from suite.result import last_digit, read_reference
from suite.row import Row

# Where the slowest mode is alone; for g = 0.9 the second one falls off so slowly that it takes twice the depth.
DEPTHS = {"0.9": (27.0, 30.0, 33.0)}
OTHER_DEPTHS = (14.0, 17.0, 20.0)
RUN_DEPTHS = {"albedo 0.5": (35.0, 38.0, 41.0), "albedo 0.5, g 0": (8.0, 11.0, 14.0)}


def compare(runs):
    return [row for name, slab in runs.items() for row in compare_run(name, slab)]


def compare_run(name, slab):
    found = []
    for row in read_reference("decay_constant.csv"):
        band = f"{row['w']} {row['g']}"
        if band in slab.bands:
            depths = RUN_DEPTHS.get(name) or DEPTHS.get(row["g"], OTHER_DEPTHS)
            near, middle, far = (slab.at((5, 5, depth), band)["fluence"] for depth in depths)
            found.append(Row(f"k at w {row['w']}, g {row['g']}", rate(near, middle, far), float(row["k"]), last_digit(row["k"]),
                             plot="rate of decay", curve=f"g = {row['g']}", x=float(row["w"])))
    return found


def rate(near, middle, far):
    """Fluence is a exp(-k tau) + b exp(k tau), with light from the far face, so near + far = 2 cosh(3 k) middle; 3 from one to the next."""
    return math.acosh((near + far) / (2 * middle)) / 3
