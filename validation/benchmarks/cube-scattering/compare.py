# SPDX-License-Identifier: AGPL-3.0-or-later
"""Flux on walls and fluence along the axis; bands are triples of extinction, albedo and mean cosine."""

from suite.result import read_reference
from suite.row import Row


def compare(runs):
    found = []
    for row in read_reference("cube_scattering_hot_medium.csv"):
        where = "opposite" if row["quantity"] == "q" else "axis"
        s = float(row["x"] if where == "opposite" else row["z"])
        found.append(row_of(runs["hot gas"], where, s, row, "hot gas, flux on a wall" if where == "opposite" else ""))
    for row in read_reference("cube_scattering_hot_wall.csv"):
        found.append(row_of(runs["hot wall" if row["g"] == "0" else "hot wall, forward"], row["where"], float(row["s"]), row,
                            "hot wall, G/4 along the axis" if row["where"] == "axis" else ""))
    return found + list(rows_by_photons(runs["hot wall, forward"], runs["hot wall, forward, photons"]))


def rows_by_photons(ordinates, photons):
    """Every point of a run, those without a published value too."""
    for row, known in zip(ordinates.probes, photons.probes, strict=True):
        column = "fluence" if row["probe"] == "axis" else "irradiance"
        yield Row(f"{ordinates.name}, beside photons: {row['probe']} ({row['x']}, {row['y']}, {row['z']})", float(row[column]),
                  float(known[column]), float(known[f"{column}_error"]))


def row_of(cube, where, s, row, plot):
    band = f"{row['beta']} {row['w']} {row['g']}"
    point = {"opposite": (s, 0.5, 0.0), "axis": (0.5, 0.5, s), "side": (0.0, 0.5, s)}[where]
    place = cube.at(point, band, where)
    value = place["irradiance"] if row["quantity"] == "q" else place["fluence"] / 4
    curve = "beta {}, albedo {}, g {}".format(*band.split())
    return Row(f"{cube.name}, {curve}: {where} {s:g}", value, float(row["value"]), float(row["sd"]), plot=plot, curve=curve, x=s)
