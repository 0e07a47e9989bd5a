# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence at four depths, its mean, and the flux through a face; bands are pairs of albedo and thickness."""

from suite.result import last_digit, read_reference
from suite.row import Line, Row

PLOT = "fluence by depth"
DEPTHS = (("phi_0", 0.0), ("phi_tau/8", 0.125), ("phi_tau/4", 0.25), ("phi_tau/2", 0.5))


def compare(runs):
    slab = runs["case"]
    found = []
    for row in read_reference("emitting_slab.csv"):
        band = f"{row['c']} {row['tau']}"
        for column, depth in DEPTHS:
            found.append(Row(f"fluence at {depth} tau, {label(band)}", slab.at((0.5, 0.5, depth), band)["fluence"],
                             float(row[column]), last_digit(row[column]), plot=PLOT, curve=label(band), x=depth))
        mean = sum(slab.region(region, "fluence_mean", band) * slab.region(region, "volume", band)
                   for region in slab.regions()) / sum(slab.region(region, "volume", band) for region in slab.regions())
        found.append(Row(f"mean fluence, {label(band)}", mean, float(row["phi_mean"]), last_digit(row["phi_mean"])))
        found.append(Row(f"flux through a face, {label(band)}", slab.wall("zmin", "irradiance_mean", band),
                         float(row["J_out"]), last_digit(row["J_out"])))
    return found


def label(band):
    c, tau = band.split()
    return f"c {c}, tau {tau}"


def lines(runs):
    return [Line(PLOT, label(band), [p["z"] for p in points if p["z"] <= 0.5], [p["fluence"] for p in points if p["z"] <= 0.5])
            for band in runs["case"].bands for points in [runs["case"].probe("depth", band)]]
