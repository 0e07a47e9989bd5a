# SPDX-License-Identifier: AGPL-3.0-or-later
"""A slab of gas, 0 <= z <= 1, that absorbs and emits between gray walls "zmin" and "zmax": the formal solution."""

import math

import numpy

from suite.row import Line, Row

HEIGHTS = (0.0, 0.25, 0.5, 0.75, 1.0)
PLOT = "fluence by height"
NODES, WEIGHTS = (0.5 * (v + shift) for v, shift in zip(numpy.polynomial.legendre.leggauss(160), (1, 0)))  # on [0, 1]


class EmittingSlab:
    """One band: radiosities of the walls, then fluence and fluxes.

    `depth(z)` is the optical depth [1] of the gas below a height [m] and `height` its inverse; `blackbody(z)` the
    radiance [W/(m^2 sr)] of a blackbody of the gas's temperature; `walls` the same of each wall, with its emissivity.
    """

    def __init__(self, depth, height, blackbody, walls):
        self.depth, self.height, self.blackbody = depth, height, blackbody
        self.whole = depth(1.0)
        # Both hemispheres by mu = t^2, which is smooth where rays graze.
        self.mu, self.weight = NODES ** 2, 2 * NODES * WEIGHTS
        through = 2 * numpy.sum(self.weight * self.mu * numpy.exp(-self.whole / self.mu))
        incident = {wall: 2 * math.pi * numpy.sum(self.weight * self.mu * self.emitted(z, down))
                    for wall, z, down in (("zmin", 0.0, True), ("zmax", 1.0, False))}
        own = {wall: emissivity * math.pi * radiance for wall, (radiance, emissivity) in walls.items()}
        r0, r1 = 1 - walls["zmin"][1], 1 - walls["zmax"][1]
        matrix = [[1, -r0 * through], [-r1 * through, 1]]
        sent = numpy.linalg.solve(matrix, [own["zmin"] + r0 * incident["zmin"], own["zmax"] + r1 * incident["zmax"]])
        self.sent = dict(zip(("zmin", "zmax"), sent))
        self.net = {"zmin": incident["zmin"] + through * sent[1] - sent[0], "zmax": incident["zmax"] + through * sent[0] - sent[1]}

    def emitted(self, z, down):
        """Radiance of the gas that arrives at a height, by cosine, without that of the wall behind it."""
        depth = self.depth(z)
        length = self.whole - depth if down else depth
        if length == 0:
            return numpy.zeros_like(self.mu)
        return numpy.array([self.along(depth, length, down, mu) for mu in self.mu])

    def along(self, depth, length, down, mu):
        last = math.exp(-length / mu)
        pieces = numpy.geomspace(max(last, 1e-18), 1.0, 9) if last < 0.5 else numpy.array([last, 1.0])
        total = 0.0
        for a, b in zip(pieces[:-1], pieces[1:]):
            distance = -mu * numpy.log(a + (b - a) * NODES)
            depths = numpy.clip(depth + distance if down else depth - distance, 0, self.whole)
            total += (b - a) * numpy.sum(WEIGHTS * self.blackbody(self.height(depths)))
        return total

    def fluence(self, z):
        found = 0.0
        for down, wall, length in ((True, "zmax", self.whole - self.depth(z)), (False, "zmin", self.depth(z))):
            radiance = self.emitted(z, down) + self.sent[wall] / math.pi * numpy.exp(-length / self.mu)
            found += 2 * math.pi * numpy.sum(self.weight * radiance)
        return found


def slab_rows(result, slabs):
    """Heat fluxes, mean divergence and fluences of a run, against the slab of each band."""
    found = []
    for wall in ("zmin", "zmax"):
        found.append(Row(f"heat flux into {wall}", result.heat(wall, "density"), sum(slab.net[wall] for slab in slabs.values())))
    exact = sum(net for slab in slabs.values() for net in slab.net.values())
    found.append(Row("mean divergence of the heat flux", result.heat("gas", "density"), exact))
    for band, slab in slabs.items():
        for z in HEIGHTS:
            found.append(Row(f"fluence at {z:g} m, {band}", result.at((0.5, 0.5, z), band)["fluence"], slab.fluence(z),
                             plot=PLOT, curve=band, x=z))
    return found


def slab_lines(result):
    return [Line(PLOT, band, [p["z"] for p in points], [p["fluence"] for p in points])
            for band in result.bands for points in [result.probe("height", band)]]
