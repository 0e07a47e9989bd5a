# SPDX-License-Identifier: AGPL-3.0-or-later
"""Heat fluxes, divergence and fluence, against the formal solution along rays with Planck's law integrated anew."""

import math

import numpy

from suite.emitting_slab import NODES, WEIGHTS, EmittingSlab, slab_lines, slab_rows

ABSORPTION = {"short": 0.5, "long": 3.0}
EDGES = {"short": (1e-9, 3e-6), "long": (3e-6, 1.0)}  # [m]
WALLS = {"zmin": (900.0, 0.6), "zmax": (400.0, 0.8)}  # temperature [K], emissivity
PLANCK, LIGHT, BOLTZMANN = 6.62607015e-34, 299792458.0, 1.380649e-23


def temperature(z):
    return 1500 - 800 * z


def blackbody(kelvin, band):
    """Radiance in a band [W/(m^2 sr)]: 2 (kT)^4/(h^3 c^2) times the integral of x^3/(e^x - 1)."""
    low, high = (PLANCK * LIGHT / (BOLTZMANN * kelvin * edge) for edge in reversed(EDGES[band]))
    high = min(high, 200.0)
    pieces = numpy.linspace(low, high, 41)
    total = 0.0
    for a, b in zip(pieces[:-1], pieces[1:]):
        x = a + (b - a) * NODES
        total += (b - a) * numpy.sum(WEIGHTS * x ** 3 / numpy.expm1(x))
    return 2 * (BOLTZMANN * kelvin) ** 4 / (PLANCK ** 3 * LIGHT ** 2) * total


class Table:
    """Radiance of the gas by height as a Chebyshev series, whose last coefficients are rounding."""

    def __init__(self, band):
        self.series = numpy.polynomial.Chebyshev.interpolate(
            numpy.vectorize(lambda z: blackbody(temperature(z), band)), 40, domain=[0, 1])

    def __call__(self, z):
        return self.series(z)


def slab(band):
    kappa = ABSORPTION[band]
    walls = {wall: (blackbody(kelvin, band), emissivity) for wall, (kelvin, emissivity) in WALLS.items()}
    return EmittingSlab(lambda z: kappa * z, lambda depth: depth / kappa, Table(band), walls)


def compare(runs):
    return slab_rows(runs["case"], {band: slab(band) for band in ABSORPTION})


def lines(runs):
    return slab_lines(runs["case"])
