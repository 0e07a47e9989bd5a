# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence 4 pi L at the probes and in every node of the field."""

import math

from pictures.results import array, read_fields
from suite.row import Row

RADIANCE = {"one": 1.0, "two": 2.0, "five": 5.0}


def compare(runs):
    furnace = runs["case"]
    found = [Row(f"{row['probe']} {row['index']}, L {row['band']}", float(row["fluence"]), exact(row["band"]))
             for row in furnace.probes]
    values = array(read_fields(furnace.folder).GetPointData(), "fluence")
    for k, band in enumerate(furnace.bands):
        found.append(Row(f"smallest fluence, L {band}", values[:, k].min(), exact(band)))
        found.append(Row(f"largest fluence, L {band}", values[:, k].max(), exact(band)))
    return found


def exact(band):
    return 4 * math.pi * RADIANCE[band]
