# SPDX-License-Identifier: AGPL-3.0-or-later
"""Heat fluxes, divergence and fluence, against the formal solution along rays with Planck's law integrated anew."""

import numpy

from suite import planck
from suite.emitting_slab import EmittingSlab, slab_lines, slab_rows

ABSORPTION = {"short": 0.5, "long": 3.0}
EDGES = {"short": (1e-9, 3e-6), "long": (3e-6, 1.0)}  # [m]
WALLS = {"zmin": (900.0, 0.6), "zmax": (400.0, 0.8)}  # temperature [K], emissivity


def temperature(z):
    return 1500 - 800 * z


def blackbody(kelvin, band):
    """Radiance in a band [W/(m^2 sr)]."""
    return planck.radiance(kelvin, *EDGES[band])


class Table:
    """Radiance of the gas by height as a Chebyshev series, whose last coefficients are rounding."""

    def __init__(self, band):
        self.series = numpy.polynomial.Chebyshev.interpolate(
            lambda z: blackbody(temperature(z), band), 40, domain=[0, 1])

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
