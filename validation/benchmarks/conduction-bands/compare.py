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


class Slab:
    """Temperatures of the cells, and of the upper plate where it is cooled by convection, found by Newton's method."""

    def __init__(self, gases, conductivity, cooling, cells):
        self.bands = [Light(kappa, blackbody, cells) for kappa, blackbody in gases]
        self.cooling = cooling
        width = 1 / cells
        self.conduction = numpy.zeros((cells + 1, cells + 2))  # flux at the faces by temperatures, plates last
        for f in range(cells + 1):
            below, above = (cells if f == 0 else f - 1), (cells + 1 if f == cells else f)
            distance = width / 2 if f in (0, cells) else width
            self.conduction[f, below], self.conduction[f, above] = conductivity / distance, -conductivity / distance
        self.kelvin = numpy.append(numpy.linspace(HOT, COLD, cells), [HOT, COLD])
        free = [*range(cells), *([cells + 1] if cooling else [])]
        for _ in range(60):
            change = numpy.linalg.solve(self.slopes(width)[numpy.ix_(free, free)], -self.gains(width)[free])
            self.kelvin[free] += change
            if abs(change).max() < 1e-9 * HOT:
                break

    def radiated(self):
        return sum(band.flux @ band.blackbody(self.kelvin) for band in self.bands)

    def conducted(self):
        return self.conduction @ self.kelvin

    def gains(self, width):
        """Of the cells, the lower plate (which is held) and the upper one [W/m^2]."""
        flux = self.radiated() + self.conducted()
        of_plate = flux[-1]
        if self.cooling:
            of_plate += self.cooling["heat_flux"] - self.cooling["h"] * (self.kelvin[-1] - self.cooling["ambient"])
        return numpy.append(SOURCE * width - numpy.diff(flux), [0, of_plate])

    def slopes(self, width):
        """Derivatives of the gains by the temperatures."""
        step = 1e-4 * self.kelvin
        of_flux = self.conduction.copy()
        for band in self.bands:
            of_flux += band.flux * (band.blackbody(self.kelvin + step) - band.blackbody(self.kelvin - step)) / (2 * step)
        of_plate = of_flux[-1].copy()
        if self.cooling:
            of_plate[-1] -= self.cooling["h"]
        return numpy.vstack([-numpy.diff(of_flux, axis=0), numpy.zeros_like(of_plate), of_plate])

    def values(self):
        radiated, conducted = self.radiated(), self.conducted()
        found = {"heat flux into zmin": -radiated[0], "heat flux into zmax": radiated[-1],
                 "conducted into zmin": -conducted[0], "conducted into zmax": conducted[-1]}
        if self.cooling:
            found["temperature of zmax"] = self.kelvin[-1]
        for b, band in enumerate(self.bands):
            fluence = band.fluence @ band.blackbody(self.kelvin)
            found |= {f"fluence at {z:g} m, {b}": fluence[round(z * (len(fluence) - 1))] for z in HEIGHTS}
        return found


def exact(gases, conductivity, cooling):
    """Errors are of second order in the width of the cells."""
    coarse, fine = (Slab(gases, conductivity, cooling, cells).values() for cells in (60, 120))
    return {key: (4 * fine[key] - coarse[key]) / 3 for key in fine}


TWO_BANDS = [(kappa, lambda kelvin, band=band: planck.radiance(kelvin, *EDGES[band])) for band, kappa in (("short", 0.5), ("long", 4.0))]
FLUE_GAS = [(0.3 + 0.3 * bordbar.absorption(gas), lambda kelvin, gas=gas: bordbar.blackbody(kelvin, gas)) for gas in range(5)]
COOLING = {"h": 200.0, "ambient": 300.0, "heat_flux": 5000.0}
CASES = {  # bands, conductivity [W/(m K)], what cools the upper plate
    "two bands": (TWO_BANDS, 0.0, None),
    "flue gas": (FLUE_GAS, 20.0, None),
    "cooled plate": (TWO_BANDS, 20.0, COOLING),
}


def compare(runs):
    found = []
    for name, (gases, conductivity, cooling) in CASES.items():
        result, wanted = runs[name], exact(gases, conductivity, cooling)
        for key, reference in wanted.items():
            if conductivity or not key.startswith("conducted"):
                found.append(Row(f"{key}, {name}", value_of(result, key), reference))
    return found


def value_of(result, key):
    if key.startswith("heat flux"):
        return result.heat(key.split()[-1], "density")
    if key.startswith("temperature"):
        return result.heat(key.split()[-1], "temperature")
    if key.startswith("conducted"):
        return result.heat(key.split()[-1], "conducted")
    height, band = key.removeprefix("fluence at ").split(" m, ")
    return result.at((0.5, 0.5, float(height)), result.bands[int(band)])["fluence"]
