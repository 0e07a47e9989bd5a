# SPDX-License-Identifier: AGPL-3.0-or-later
"""A heated slab between black plates by finite volumes: radiation along rays with a constant source in each, conduction,
and Newton's method; steady, or by implicit steps in time."""

import math

import numpy

from suite.emitting_slab import NODES, WEIGHTS

HOT, COLD = 1500.0, 700.0  # [K] of the plates
MU, MU_WEIGHTS = NODES ** 2, 2 * NODES * WEIGHTS


def march(up, down, passes):
    """Light [face][cosine][source] through even cells that send out 1 - passes, from the first face of `up` and the last of `down` on."""
    cells = len(up) - 1
    for f in range(cells):
        up[f + 1] = up[f] * passes[:, None]
        up[f + 1, :, f] += 1 - passes
        g = cells - 1 - f
        down[g] = down[g + 1] * passes[:, None]
        down[g, :, g] += 1 - passes


def extrapolated(coarse, fine, factor=4):
    """Numbers by name, without the error that falls by `factor` from the coarse ones to the fine ones."""
    return {key: (factor * fine[key] - coarse[key]) / (factor - 1) for key in fine}


class Light:
    """One band on even cells: flux and fluence at the faces, linear in the sources of the cells and of both plates."""

    def __init__(self, kappa, blackbody, cells):
        self.blackbody = blackbody
        passes = numpy.exp(-kappa / cells / MU)
        up = numpy.zeros((cells + 1, len(MU), cells + 2))  # [face][cosine][source], plates last
        down = numpy.zeros_like(up)
        up[0, :, cells], down[cells, :, cells + 1] = 1, 1
        march(up, down, passes)
        self.flux = 2 * math.pi * numpy.einsum("m,fms->fs", MU_WEIGHTS * MU, up - down)
        self.fluence = 2 * math.pi * numpy.einsum("m,fms->fs", MU_WEIGHTS, up + down)


class Slab:
    """Temperatures of the cells, and of the upper plate where it is cooled by convection, found by Newton's method.

    The conductivity is a number or a function of the temperature."""

    def __init__(self, gases, conductivity, cooling, source, cells):
        self.bands = [Light(kappa, blackbody, cells) for kappa, blackbody in gases]
        self.cooling, self.source, self.width = cooling, source, 1 / cells
        self.conductivity = conductivity if callable(conductivity) else lambda kelvin: conductivity + 0 * kelvin
        below = numpy.array([cells, *range(cells)])
        above = numpy.array([*range(cells), cells + 1])
        self.beside = below, above  # of each face; plates last
        self.distance = numpy.full(cells + 1, self.width)
        self.distance[[0, -1]] /= 2
        self.kelvin = numpy.append(numpy.linspace(HOT, COLD, cells), [HOT, COLD])
        self.free = [*range(cells), *([cells + 1] if cooling else [])]

    def solve(self, inertia=0.0, before=None):
        """`inertia` is a heat capacity over a step [W/(m^3 K)], for a step from the temperatures `before`."""
        before = self.kelvin.copy() if before is None else before
        storing = numpy.zeros(len(self.kelvin))
        storing[:-2] = inertia * self.width
        for _ in range(60):
            gains = self.gains() - storing * (self.kelvin - before)
            slopes = self.slopes() - numpy.diag(storing)
            change = numpy.linalg.solve(slopes[numpy.ix_(self.free, self.free)], -gains[self.free])
            self.kelvin[self.free] += change
            if abs(change).max() < 1e-9 * HOT:
                return self
        raise ArithmeticError("Newton's method does not converge")

    def radiated(self):
        return sum(band.flux @ band.blackbody(self.kelvin) for band in self.bands)

    def conducted(self):
        below, above = (self.kelvin[side] for side in self.beside)
        return self.conductivity((below + above) / 2) * (below - above) / self.distance

    def gains(self):
        """Of the cells, the lower plate (which is held) and the upper one [W/m^2]."""
        flux = self.radiated() + self.conducted()
        of_plate = flux[-1]
        if self.cooling:
            of_plate += self.cooling["heat_flux"] - self.cooling["h"] * (self.kelvin[-1] - self.cooling["ambient"])
        return numpy.append(self.source * self.width - numpy.diff(flux), [0, of_plate])

    def slopes(self):
        """Derivatives of the gains by the temperatures; the conductivity is that of the last step of Newton's method."""
        step = 1e-4 * self.kelvin
        of_flux = numpy.zeros((len(self.distance), len(self.kelvin)))
        below, above = self.beside
        faces = numpy.arange(len(self.distance))
        by_face = self.conductivity((self.kelvin[below] + self.kelvin[above]) / 2) / self.distance
        of_flux[faces, below], of_flux[faces, above] = by_face, -by_face
        for band in self.bands:
            of_flux += band.flux * (band.blackbody(self.kelvin + step) - band.blackbody(self.kelvin - step)) / (2 * step)
        of_plate = of_flux[-1].copy()
        if self.cooling:
            of_plate[-1] -= self.cooling["h"]
        return numpy.vstack([-numpy.diff(of_flux, axis=0), numpy.zeros_like(of_plate), of_plate])

    def at(self, height):
        """Temperature of the gas, between its cells."""
        centers = (numpy.arange(len(self.kelvin) - 2) + 0.5) * self.width
        return numpy.interp(height, numpy.concatenate([[0], centers, [1]]), self.kelvin[[-2, *range(len(centers)), -1]])
