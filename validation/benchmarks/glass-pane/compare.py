# SPDX-License-Identifier: AGPL-3.0-or-later
"""A pane between airs by finite volumes: radiation along rays with a constant source in each cell, which both faces reflect,
conduction, and Newton's method."""

import math

import numpy

from suite import planck
from suite.heated_slab import extrapolated, march
from suite.row import Row

THICKNESS, INDEX = 0.01, 1.5  # [m]
SOURCE, OUTSIDE = 1e7, 300.0  # [W/m^3], [K]
COOLING = (20.0, 120.0)  # of the lower and the upper face [W/(m^2 K)]
BANDS = {"clear": (20.0, (1e-9, 2.7e-6)), "half": (200.0, (2.7e-6, 4.5e-6)), "opaque": (1000.0, (4.5e-6, 1.0))}
DEPTHS = (0.0, 0.0025, 0.005, 0.0075, 0.01)  # [m]
CRITICAL = math.sqrt(1 - 1 / INDEX ** 2)  # cosine below which all is reflected


def cosines(count):
    """Gauss points below and above the critical cosine; above, by the square from there on, as the reflectance has a root there."""
    x, w = numpy.polynomial.legendre.leggauss(count)
    x, w = (x + 1) / 2, w / 2
    below, above = CRITICAL * x ** 2, CRITICAL + (1 - CRITICAL) * x ** 2
    return numpy.concatenate([below, above]), numpy.concatenate([2 * CRITICAL * w * x, 2 * (1 - CRITICAL) * w * x])


def reflectance(mu):
    """Fresnel's, of unpolarized light from within."""
    outer = numpy.sqrt(numpy.maximum(0.0, 1 - INDEX ** 2 * (1 - mu ** 2)))
    across, along = (INDEX * mu - outer) / (INDEX * mu + outer), (mu - INDEX * outer) / (mu + INDEX * outer)
    return numpy.where(outer > 0, (across ** 2 + along ** 2) / 2, 1.0)


class Light:
    """One band on even cells: flux and fluence at the faces, linear in the blackbodies of the cells and of what is outside."""

    def __init__(self, kappa, cells, points=48):
        mu, weight = cosines(points)
        rho = reflectance(mu)
        passes = numpy.exp(-kappa * THICKNESS / cells / mu)
        up = numpy.zeros((cells + 1, len(mu), cells + 1))  # [face][cosine][source], outside last
        down = numpy.zeros_like(up)
        march(up, down, passes)
        # That of the cells alone: from it follows the exitance of the lower face, with reflection at both and the light that enters.
        whole = passes ** cells
        entering = numpy.zeros((len(mu), cells + 1))
        entering[:, -1] = 1 - rho
        both = (rho * whole)[:, None]
        first = entering + rho[:, None] * (down[0] + whole[:, None] * (rho[:, None] * up[-1] + entering))
        up[0] = first / (1 - both ** 2)
        down[-1] = rho[:, None] * (up[-1] + whole[:, None] * up[0]) + entering
        up[1:], down[:-1] = 0, 0
        march(up, down, passes)
        self.flux = 2 * math.pi * INDEX ** 2 * numpy.einsum("m,fms->fs", weight * mu, up - down)
        self.fluence = 2 * math.pi * INDEX ** 2 * numpy.einsum("m,fms->fs", weight, up + down)


class Pane:
    """Temperatures of the cells, and last of the lower and the upper face."""

    def __init__(self, cells):
        self.light = {band: (Light(kappa, cells), edges) for band, (kappa, edges) in BANDS.items()}
        self.width = THICKNESS / cells
        self.kelvin = numpy.full(cells + 2, 800.0)

    def blackbody(self, edges):
        return planck.radiance(numpy.append(self.kelvin[:-2], OUTSIDE), *edges)

    def radiated(self):
        return sum(light.flux @ self.blackbody(edges) for light, edges in self.light.values())

    def conducted(self):
        """Upwards through each face of the cells."""
        along = numpy.concatenate([self.kelvin[-2:-1], self.kelvin[:-2], self.kelvin[-1:]])
        distance = numpy.full(len(along) - 1, self.width)
        distance[[0, -1]] /= 2
        return (0.8 + 7e-4 * (along[1:] + along[:-1]) / 2) * (along[:-1] - along[1:]) / distance

    def convected(self):
        """Away from the lower and the upper face."""
        return numpy.array(COOLING) * (self.kelvin[-2:] - OUTSIDE)

    def gains(self):
        conducted = self.conducted()
        through = conducted + self.radiated()
        at_faces = numpy.array([-conducted[0], conducted[-1]]) - self.convected()
        return numpy.append(SOURCE * self.width - numpy.diff(through), at_faces)

    def solve(self):
        for _ in range(30):
            gains, slopes = self.gains(), []
            for j in range(len(self.kelvin)):
                here = self.kelvin[j]
                self.kelvin[j] = here + 0.05
                above = self.gains()
                self.kelvin[j] = here - 0.05
                slopes.append((above - self.gains()) / 0.1)
                self.kelvin[j] = here
            change = numpy.linalg.solve(numpy.array(slopes).T, -gains)
            self.kelvin += change
            if abs(change).max() < 1e-8:
                return self
        raise ArithmeticError("Newton's method does not converge")


def values(pane):
    radiated, convected = pane.radiated(), pane.convected()
    found = {("radiated", "zmin"): -radiated[0], ("radiated", "zmax"): radiated[-1],
             ("convected", "zmin"): convected[0], ("convected", "zmax"): convected[1],
             ("temperature", "glass"): pane.kelvin[:-2].mean()}
    for band, (light, edges) in pane.light.items():
        fluence = light.fluence @ pane.blackbody(edges)
        found |= {(band, depth): fluence[round(depth / THICKNESS * (len(fluence) - 1))] for depth in DEPTHS}
    return found


def exact():
    return extrapolated(*(values(Pane(cells).solve()) for cells in (40, 80)))


def compare(runs):
    result = runs["case"]
    return [Row(f"{what} {where}" if isinstance(where, str) else f"fluence at {1000 * where:g} mm, {what}",
                value_of(result, what, where), reference) for (what, where), reference in exact().items()]


def value_of(result, what, where):
    if what == "radiated":
        return result.heat(where, "density")
    if what == "convected":
        return result.heat(where, "convected") / result.heat(where, "extent")
    if what == "temperature":
        return result.heat(where, "temperature")
    return result.at((0.004, 0.004, where), what)["fluence"]
