# SPDX-License-Identifier: AGPL-3.0-or-later
"""Powers absorbed and fluence beside and above the capsule; of a quarter, 0.3 thick, made those of the whole, 1 thick."""

import math

from suite.result import read_reference
from suite.row import Row

WHOLE = 4 / 0.3

# Of a quantity: the regions, or the walls, whose values are added, and the column.
QUANTITIES = {
    "absorption capsule (": ("region", ("capsule", "core"), "absorbed"),
    "absorption capsule core": ("region", ("core",), "absorbed"),
    "absorption top and bottom walls": ("region", ("top",), "absorbed"),
    "phi mean in 0.05x0.05 box at (+-0.4 0)": ("region", ("beside",), "fluence_mean"),
    "phi mean in 0.05x0.05 box at (0 +-0.5)": ("region", ("above",), "fluence_mean"),
    "total outflow": ("wall", ("xmax", "ymax"), "incoming"),
    "total inflow": ("wall", ("xmax",), "outgoing"),
}


def compare(runs):
    return [row for name, result in runs.items() for row in rows_of(name, result)]


def rows_of(name, result):
    for row in read_reference("hohlraum.csv"):
        kind, places, column = next(how for start, how in QUANTITIES.items() if row["quantity"].startswith(start))
        scale = 1 if column == "fluence_mean" else WHOLE
        value = scale * sum(getattr(result, kind)(place, column) for place in places)
        known = 5e-7 if row["sd"] == "exact" else float(row["sd"])
        yield Row(f"{name}: {row['quantity']}", value, float(row["value"]),
                  math.hypot(known, scale * noise(result, kind, places, column)))


def noise(result, kind, places, column):
    """Standard error of a sum by photons; 0 by ordinates, and of what walls emit."""
    if result.name != "photons" or column == "outgoing":
        return 0.0
    return math.hypot(*(getattr(result, kind)(place, f"{column}_error") for place in places))
