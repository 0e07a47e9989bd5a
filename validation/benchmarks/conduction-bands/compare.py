# SPDX-License-Identifier: AGPL-3.0-or-later
"""The temperature by finite volumes: radiation along rays with a constant source in each, conduction, and Newton's method."""

import math

import numpy

from suite import bordbar, planck
from suite.emitting_slab import HEIGHTS, NODES, WEIGHTS
from suite.row import Row

HOT, COLD = 1500.0, 700.0  # [K]
SOURCE = 30000.0  # [W/m^3]
MU, MU_WEIGHTS = NODES ** 2, 2 * NODES * WEIGHTS
EDGES = {"short": (1e-9, 3e-6), "long": (3e-6, 1.0)}  # [m]


class Light:
    """One band on even cells: flux and fluence at the faces, linear in the sources of the cells and of both plates."""

    def __init__(self, kappa, blackbody, cells):
        self.blackbody = blackbody
        passes = numpy.exp(-kappa / cells / MU)
        up = numpy.zeros((cells + 1, len(MU), cells + 2))  # [face][cosine][source], plates last
        down = numpy.zeros_like(up)
        up[0, :, cells], down[cells, :, cells + 1] = 1, 1
        for f in range(cells):
            up[f + 1] = up[f] * passes[:, None]
            up[f + 1, :, f] += 1 - passes
            g = cells - 1 - f
            down[g] = down[g + 1] * passes[:, None]
            down[g, :, g] += 1 - passes
        self.flux = 2 * math.pi * numpy.einsum("m,fms->fs", MU_WEIGHTS * MU, up - down)
        self.fluence = 2 * math.pi * numpy.einsum("m,fms->fs", MU_WEIGHTS, up + down)

    def sources(self, kelvin):
        return self.blackbody(numpy.append(kelvin, [HOT, COLD]))


class Slab:
    """Temperatures of the cells, found by Newton's method."""

    def __init__(self, gases, conductivity, cells):
        self.bands = [Light(kappa, blackbody, cells) for kappa, blackbody in gases]
        width = 1 / cells
        self.conduction = numpy.zeros((cells + 1, cells + 2))  # flux at the faces by temperatures, plates last
        for f in range(cells + 1):
            below, above = (cells if f == 0 else f - 1), (cells + 1 if f == cells else f)
            distance = width / 2 if f in (0, cells) else width
            self.conduction[f, below], self.conduction[f, above] = conductivity / distance, -conductivity / distance
        kelvin = numpy.linspace(HOT, COLD, cells)
        for _ in range(30):
            radiated = sum(band.flux @ band.sources(kelvin) for band in self.bands)
            self.conducted = self.conduction @ numpy.append(kelvin, [HOT, COLD])
            gain = SOURCE * width - numpy.diff(radiated + self.conducted)
            step = 1e-4 * kelvin
            jacobian = -numpy.diff(self.conduction[:, :cells], axis=0)
            for band in self.bands:
                slope = (band.blackbody(kelvin + step) - band.blackbody(kelvin - step)) / (2 * step)
                jacobian -= numpy.diff(band.flux[:, :cells], axis=0) * slope
            change = numpy.linalg.solve(jacobian, -gain)
            kelvin = kelvin + change
            if abs(change).max() < 1e-9 * HOT:
                break
        self.radiated = sum(band.flux @ band.sources(kelvin) for band in self.bands)
        self.conducted = self.conduction @ numpy.append(kelvin, [HOT, COLD])
        self.fluences = [band.fluence @ band.sources(kelvin) for band in self.bands]

    def values(self):
        found = {"heat flux into zmin": -self.radiated[0], "heat flux into zmax": self.radiated[-1],
                 "conducted into zmin": -self.conducted[0], "conducted into zmax": self.conducted[-1]}
        for b, fluence in enumerate(self.fluences):
            found |= {f"fluence at {z:g} m, {b}": fluence[round(z * (len(fluence) - 1))] for z in HEIGHTS}
        return found


def exact(gases, conductivity):
    """Errors are of second order in the width of the cells."""
    coarse, fine = (Slab(gases, conductivity, cells).values() for cells in (60, 120))
    return {key: (4 * fine[key] - coarse[key]) / 3 for key in fine}


GASES = {
    "two bands": ([(kappa, lambda kelvin, band=band: planck.radiance(kelvin, *EDGES[band])) for band, kappa in (("short", 0.5), ("long", 4.0))], 0.0),
    "flue gas": ([(0.3 + 0.3 * bordbar.absorption(gas), lambda kelvin, gas=gas: bordbar.blackbody(kelvin, gas)) for gas in range(5)], 20.0),
}


def compare(runs):
    found = []
    for name, (gases, conductivity) in GASES.items():
        result, wanted = runs[name], exact(gases, conductivity)
        for key, reference in wanted.items():
            if conductivity or not key.startswith("conducted"):
                found.append(Row(f"{key}, {name}", value_of(result, key), reference))
    return found


def value_of(result, key):
    if key.startswith("heat flux"):
        return result.heat(key.split()[-1], "density")
    if key.startswith("conducted"):
        return result.heat(key.split()[-1], "conducted")
    height, band = key.removeprefix("fluence at ").split(" m, ")
    return result.at((0.5, 0.5, float(height)), result.bands[int(band)])["fluence"]
