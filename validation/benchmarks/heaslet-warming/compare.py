# SPDX-License-Identifier: AGPL-3.0-or-later
"""Flux and emissive power; bands are optical thicknesses."""

from suite.result import last_digit, read_reference
from suite.row import Line, Row

DEPTHS = (("theta_0", 0.0), ("theta_tau/8", 0.125), ("theta_tau/4", 0.25), ("theta_3tau/8", 0.375), ("theta_tau/2", 0.5))
FLUX, POWER = "flux by thickness", "emissive power by depth"
SHOWN = ("0.1", "1.0", "10.0", "50.0")


def compare(runs):
    found = []
    for row in read_reference("heaslet_warming.csv"):
        band = row["tau"]
        slab = run_of(runs, band)
        found.append(Row(f"Q, tau {band}", slab.wall("zmax", "incoming", band) / slab.wall("zmin", "outgoing", band), float(row["Q"]), last_digit(row["Q"]), plot=FLUX,
                         curve="Q", x=float(band)))
        for column, depth in DEPTHS:
            found.append(Row(f"theta at {depth}, tau {band}", slab.at((0.5, 0.5, depth), band)["fluence"] / 4,
                             float(row[column]), last_digit(row[column]), plot=POWER if band in SHOWN else "",
                             curve=f"tau {band}", x=depth))
    return found


def run_of(runs, band):
    return runs["thin" if float(band) < 1 else "thick"]


def lines(runs):
    return [Line(POWER, f"tau {band}", [p["z"] for p in points], [p["fluence"] / 4 for p in points])
            for band in SHOWN for points in [run_of(runs, band).probe("depth", band)]]
