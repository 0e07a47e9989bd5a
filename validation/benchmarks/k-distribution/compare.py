# SPDX-License-Identifier: AGPL-3.0-or-later
"""The spectrum line by line, and a heated gas by finite volumes (suite.heated_slab)."""

import csv
import math
import pathlib

import numpy

from suite import bordbar, line_spectrum, planck
from suite.emitting_slab import HEIGHTS
from suite.heated_slab import Slab, extrapolated
from suite.row import Row

PRESSURE, SOOT = 0.4, 0.3  # [atm], [1/m]
WALLS = ((900.0, 0.6), (400.0, 0.8))  # temperature [K], emissivity
LAYERS, COSINES = 200, 10
HEATED = {"pressure": 0.01, "soot": 0.5, "source": 30000.0}


def blackbody(kelvin):
    """Radiance around each wave number, and last that of all others, where the gas is clear [W/(m^2 sr)]."""
    wavenumber = 100 * line_spectrum.WAVENUMBER  # [1/m]
    x = planck.PLANCK * planck.LIGHT * wavenumber / (planck.BOLTZMANN * kelvin)
    inside = 2 * planck.PLANCK * planck.LIGHT ** 2 * wavenumber ** 3 / numpy.expm1(x) * numpy.gradient(wavenumber)
    return numpy.append(inside, bordbar.STEFAN_BOLTZMANN * kelvin ** 4 / math.pi - inside.sum())


def march(depths, sources):
    """Radiance behind layers of optical depths [cosine][wave number], with a source linear in each between its two ends."""
    radiance = numpy.zeros_like(depths[0])
    for depth, before, behind in zip(depths, sources[:-1], sources[1:]):
        passes = numpy.exp(-depth)
        mean = numpy.where(depth > 1e-6, (1 - passes) / numpy.maximum(depth, 1e-300), 1 - depth / 2)
        radiance = radiance * passes + behind * (1 - mean) + before * (mean - passes)
    return radiance


def net_fluxes(absorption, blackbody_of):
    """Net heat flux into both walls, in all bands together [W/m^2], by the absorption between two heights [1/m] and the radiance of a
    blackbody at a temperature in each band."""
    x, weight = numpy.polynomial.legendre.leggauss(COSINES)
    mu, weight = (x + 1) / 2, weight / 2
    z = numpy.linspace(0, 1, LAYERS + 1)
    depth = [absorption(low, high) * (high - low) for low, high in zip(z[:-1], z[1:])]
    depths, sources = [d / mu[:, None] for d in depth], [blackbody_of(t) for t in kelvin_at(z)]

    def flux(radiance):
        return 2 * math.pi * (weight * mu) @ radiance

    incident = [flux(march(depths[::-1], sources[::-1])), flux(march(depths, sources))]
    through = 2 * (weight * mu) @ numpy.exp(-sum(depth) / mu[:, None])
    own = [emissivity * math.pi * blackbody_of(t) for t, emissivity in WALLS]
    r = [1 - emissivity for _, emissivity in WALLS]
    a, b = (own[i] + r[i] * incident[i] for i in (0, 1))
    sent = [(a + r[0] * through * b) / (1 - r[0] * r[1] * through ** 2), (b + r[1] * through * a) / (1 - r[0] * r[1] * through ** 2)]
    return [float((incident[i] + through * sent[1 - i] - sent[i]).sum()) for i in (0, 1)]


def kelvin_at(z):
    return 1500 - 800 * z


def line_by_line():
    """The absorption of a wave number is k times 1000 K/T: its mean between two heights has a logarithm."""
    k = numpy.append(line_spectrum.at_reference(), 0.0)

    def absorption(low, high):
        mean = line_spectrum.REFERENCE / 800 * math.log(kelvin_at(low) / kelvin_at(high)) / (high - low)
        return SOOT + PRESSURE * mean * k

    return net_fluxes(absorption, blackbody)


def by_table(name):
    """The same gas by the points of a table, linear between its temperatures."""
    k, kelvin, weight = points(name)

    def at(t, values):
        return numpy.array([numpy.interp(t, kelvin, column) for column in values.T])

    return net_fluxes(lambda low, high: SOOT + PRESSURE * at(kelvin_at((low + high) / 2), k),
                      lambda t: at(t, weight) * bordbar.STEFAN_BOLTZMANN * t ** 4 / math.pi)


def points(name):
    """Absorption [temperature][point] of a table [1/(m atm)], temperatures [K], and weights [temperature][point]."""
    with open(pathlib.Path(__file__).parent / name, encoding="utf-8") as file:
        lines = [[float(text) for text in line] for line in list(csv.reader(file))[1:]]
    kelvin = sorted({line[0] for line in lines})
    table = numpy.array(lines).reshape(len(kelvin), -1, 3)
    return table[:, :, 1], kelvin, table[:, :, 2]


def heated():
    """Fluxes and fluences of a gas whose temperature follows, extrapolated from two meshes."""
    absorption, kelvin, weight = points("same-8.csv")
    gases = [(HEATED["soot"] + HEATED["pressure"] * k,
              lambda t, w=weight[:, point]: numpy.interp(t, kelvin, w) * bordbar.STEFAN_BOLTZMANN * t ** 4 / math.pi)
             for point, k in enumerate(absorption[0])]
    return extrapolated(*(values(Slab(gases, 0.0, None, HEATED["source"], cells).solve()) for cells in (60, 120)))


def values(slab):
    radiated = slab.radiated()
    found = {"heat flux into zmin": -radiated[0], "heat flux into zmax": radiated[-1]}
    fluence = sum(band.fluence @ band.blackbody(slab.kelvin) for band in slab.bands)
    return found | {f"fluence at {z:g} m": fluence[round(z * (len(fluence) - 1))] for z in HEIGHTS}


def compare(runs):
    exact = line_by_line()
    found = []
    for name, table in (("8 points", "gas-8.csv"), ("16 points", "gas-16.csv")):
        for what, fluxes in (("spectrum", exact), ("table", by_table(table))):
            for wall, flux in zip(("zmin", "zmax"), fluxes):
                found.append(Row(f"heat flux into {wall}, {name}, {what}", runs[name].heat(wall, "density"), flux))
            found.append(Row(f"mean divergence, {name}, {what}", runs[name].heat("gas", "density"), sum(fluxes)))
    for key, reference in heated().items():
        found.append(Row(f"{key}, heated", heated_value(runs["heated"], key), reference))
    return found


def heated_value(result, key):
    if key.startswith("heat flux"):
        return result.heat(key.split()[-1], "density")
    height = float(key.removeprefix("fluence at ").removesuffix(" m"))
    return sum(result.at((0.5, 0.5, height), band)["fluence"] for band in result.bands)
