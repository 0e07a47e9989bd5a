# SPDX-License-Identifier: AGPL-3.0-or-later
"""Mean irradiance of the walls and mean fluence of the regions."""

from suite.result import read_reference
from suite.row import Row


def compare(runs):
    room = runs["case"]
    known = {(row["table"], row["name"], row["band"]): float(row["value"]) for row in read_reference("smoke_room.csv")}
    found = [Row(f"{wall}, {band}", room.wall(wall, "irradiance_mean", band), known["walls", wall, band])
             for band in room.bands for wall in room.walls()]
    found += [Row(f"{region}, {band}", room.region(region, "fluence_mean", band), known["regions", region, band])
              for band in room.bands for region in room.regions()]
    return found
