# SPDX-License-Identifier: AGPL-3.0-or-later
"""Heat fluxes, divergence and fluence, against the formal solution along rays with Planck's law integrated anew."""

import math

import numpy

from suite.row import Line, Row

PLOT = "fluence by height"
HEIGHTS = (0.0, 0.25, 0.5, 0.75, 1.0)
ABSORPTION = {"short": 0.5, "long": 3.0}
EDGES = {"short": (1e-9, 3e-6), "long": (3e-6, 1.0)}  # [m]
WALLS = {"zmin": (900.0, 0.6), "zmax": (400.0, 0.8)}  # temperature [K], emissivity
NODES, WEIGHTS = (0.5 * (v + shift) for v, shift in zip(numpy.polynomial.legendre.leggauss(160), (1, 0)))  # on [0, 1]
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


def along(gas, kappa, length, height, down, mu):
    """Emitted radiance that arrives at a height after `length` of gas, without that of the wall behind it."""
    last = math.exp(-kappa * length / mu)
    total = 0.0
    pieces = numpy.geomspace(max(last, 1e-18), 1.0, 9) if last < 0.5 else numpy.array([last, 1.0])
    for a, b in zip(pieces[:-1], pieces[1:]):
        u = a + (b - a) * NODES
        distance = -mu / kappa * numpy.log(u)
        total += (b - a) * numpy.sum(WEIGHTS * gas(height + distance if down else height - distance))
    return total


class Slab:
    """One band: radiosities of the walls, then fluence and fluxes."""

    def __init__(self, band):
        self.kappa, self.gas = ABSORPTION[band], Table(band)
        # Both hemispheres by mu = t^2, which is smooth where rays graze.
        self.mu, self.weight = NODES ** 2, 2 * NODES * WEIGHTS
        through = 2 * numpy.sum(self.weight * self.mu * numpy.exp(-self.kappa / self.mu))
        incident = {wall: 2 * math.pi * numpy.sum(self.weight * self.mu * self.emitted(z, down))
                    for wall, z, down in (("zmin", 0.0, True), ("zmax", 1.0, False))}
        own = {wall: emissivity * math.pi * blackbody(kelvin, band) for wall, (kelvin, emissivity) in WALLS.items()}
        r0, r1 = 1 - WALLS["zmin"][1], 1 - WALLS["zmax"][1]
        matrix = [[1, -r0 * through], [-r1 * through, 1]]
        sent = numpy.linalg.solve(matrix, [own["zmin"] + r0 * incident["zmin"], own["zmax"] + r1 * incident["zmax"]])
        self.sent = dict(zip(("zmin", "zmax"), sent))
        self.net = {"zmin": incident["zmin"] + through * sent[1] - sent[0], "zmax": incident["zmax"] + through * sent[0] - sent[1]}

    def emitted(self, z, down):
        length = 1 - z if down else z
        if length == 0:
            return numpy.zeros_like(self.mu)
        return numpy.array([along(self.gas, self.kappa, length, z, down, mu) for mu in self.mu])

    def fluence(self, z):
        found = 0.0
        for down, wall, length in ((True, "zmax", 1 - z), (False, "zmin", z)):
            radiance = self.emitted(z, down) + self.sent[wall] / math.pi * numpy.exp(-self.kappa * length / self.mu)
            found += 2 * math.pi * numpy.sum(self.weight * radiance)
        return found


def compare(runs):
    result, slabs = runs["case"], {band: Slab(band) for band in ABSORPTION}
    found = []
    for wall in WALLS:
        exact = sum(slab.net[wall] for slab in slabs.values())
        found.append(Row(f"heat flux into {wall}", result.heat(wall, "density"), exact))
    exact = sum(slab.net[wall] for slab in slabs.values() for wall in WALLS)
    found.append(Row("mean divergence of the heat flux", result.heat("gas", "density"), exact))
    for band, slab in slabs.items():
        for z in HEIGHTS:
            found.append(Row(f"fluence at {z:g} m, {band}", result.at((0.5, 0.5, z), band)["fluence"], slab.fluence(z),
                             plot=PLOT, curve=band, x=z))
    return found


def lines(runs):
    return [Line(PLOT, band, [p["z"] for p in points], [p["fluence"] for p in points])
            for band in runs["case"].bands for points in [runs["case"].probe("height", band)]]
