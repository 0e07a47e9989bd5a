# SPDX-License-Identifier: AGPL-3.0-or-later
"""Power that arrives at each wall and that is absorbed, in units of the mean wall, beside photons; and the light that a
vertical beam scatters once, beside its integral over the beam."""

import math

import numpy

from suite.result import read_reference
from suite.row import Row

WALLS = ("xmin", "xmax", "ymin", "ymax", "zmin", "zmax")


def references():
    """[lamp, g][quantity] value and standard deviation [W] for a lamp of 1 W"""
    known = {}
    for row in read_reference("lamp_in_haze.csv"):
        known.setdefault((row["lamp"], row["g"]), {})[row["quantity"]] = (float(row["value"]), float(row["sd"]))
    return known


def rows_of(name, result, known):
    mean = sum(known[wall][0] for wall in WALLS) / len(WALLS)
    by_photons = name.startswith("photons")
    balance = result.summary["balance"][0]
    values = {wall: result.wall(wall, "incoming") for wall in WALLS} | {"absorbed": balance["absorbed"]}
    errors = {quantity: 0.0 for quantity in values}
    if by_photons:
        errors = {wall: result.wall(wall, "incoming_error") for wall in WALLS}
        errors["absorbed"] = result.summary["photons"]["balance_error"][0]["absorbed"]
    for quantity, (reference, deviation) in known.items():
        yield Row(f"{name}: {quantity}", values[quantity] / mean, reference / mean,
                  math.hypot(deviation, errors[quantity]) / mean)
    if name.startswith("spot-down"):
        for one, other in (("xmin", "xmax"), ("ymin", "ymax")):
            yield Row(f"{name}: {one} less {other}", (values[one] - values[other]) / mean, 0.0)


def scattered_once(point, extinction, scattering, g):
    """Fluence of the light that a beam of irradiance 1 in 0.4 < x < 0.6, 0.3 < y < 0.5, downwards from z = 0.6, has
    scattered once: the integral of scattering p(cos) exp(-extinction (path)) / distance^2 over the beam."""
    nodes, weights = numpy.polynomial.legendre.leggauss(24)
    x, y, z = numpy.meshgrid(0.5 + 0.1 * nodes, 0.4 + 0.1 * nodes, 0.3 + 0.3 * nodes, indexing="ij")
    weight = 0.1 * 0.1 * 0.3 * numpy.einsum("i,j,k->ijk", weights, weights, weights)
    ray = numpy.stack([point[0] - x, point[1] - y, point[2] - z])
    distance = numpy.sqrt((ray**2).sum(axis=0))
    cosine = -ray[2] / distance
    phase = (1 - g * g) / (4 * math.pi * (1 + g * g - 2 * g * cosine) ** 1.5)
    return float((weight * scattering * phase * numpy.exp(-extinction * (0.6 - z + distance)) / distance**2).sum())


def rows_of_beam(result):
    absorption, scattering, g = 0.5, 1e-4, 0.6
    points = result.probe("beside")
    for one, other in zip(points[::2], points[1::2]):
        exact = scattered_once([one[axis] for axis in "xyz"], absorption + scattering, scattering, g)
        for row in (one, other):
            yield Row(f"{result.name}: ({row['x']:g}, {row['y']:g}, {row['z']:g}) / exact", row["fluence"] / exact, 1.0)
        yield Row(f"{result.name}: twin of ({one['x']:g}, {one['y']:g}, {one['z']:g})",
                  (one["fluence"] - other["fluence"]) / exact, 0.0)


def compare(runs):
    known = references()
    found = []
    for name, result in runs.items():
        if name.startswith("beam-down"):
            found += rows_of_beam(result)
            continue
        lamp, g = name.removeprefix("photons, ").removesuffix(", coarse").removesuffix(", fine").split(", g ")
        found += rows_of(name, result, known[lamp, g])
    return found
