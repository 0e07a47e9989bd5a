# SPDX-License-Identifier: AGPL-3.0-or-later
"""Heat fluxes, divergence and fluence of gray gases, against the formal solution along rays for each gas."""

import numpy

from suite import bordbar
from suite.emitting_slab import EmittingSlab, slab_lines, slab_rows

WALLS = {"zmin": (900.0, 0.6), "zmax": (400.0, 0.8)}  # temperature [K], emissivity


def temperature(z):
    return 1500 - 800 * z


def slab(gas):
    # Absorption 0.3/m by soot, and by a partial pressure of 0.3 + 0.2 z atm: 2 a z + b.
    kappa = bordbar.absorption(gas)
    a, b = 0.1 * kappa, 0.3 * kappa + 0.3
    walls = {wall: (bordbar.blackbody(kelvin, gas), emissivity) for wall, (kelvin, emissivity) in WALLS.items()}
    return EmittingSlab(lambda z: a * z ** 2 + b * z, lambda depth: 2 * depth / (b + numpy.sqrt(b ** 2 + 4 * a * depth)),
                        lambda z: bordbar.blackbody(temperature(z), gas), walls)


def compare(runs):
    result = runs["case"]
    return slab_rows(result, {band: slab(gas) for gas, band in enumerate(result.bands)})


def lines(runs):
    return slab_lines(runs["case"])
