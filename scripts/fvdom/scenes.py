# SPDX-License-Identifier: AGPL-3.0-or-later
"""The scenes of the comparison with fvDOM: a box of 1 x 1 x 2 m, a hot gray gas and walls of one kind."""

import dataclasses

import numpy

STEFAN_BOLTZMANN = 5.670374419e-8  # [W/(m^2 K^4)]
SIDES = numpy.array([1.0, 1.0, 2.0])  # of the box [m]
FLAME = "600 + 1200*exp(-((x-0.5)^2 + (y-0.5)^2 + (z-0.7)^2)/0.1)"


def uniform(points):
    return numpy.full(points.shape[:-1], 1500.0)


def flame(points):
    """Temperatures [K] of FLAME at points [..., 3]."""
    squared = ((points - [0.5, 0.5, 0.7]) ** 2).sum(axis=-1)
    return 600 + 1200 * numpy.exp(-squared / 0.1)


@dataclasses.dataclass(frozen=True)
class Scene:
    """A gas and its walls. Without scattering the walls are black and cold, and the wall flux is exact."""
    name: str
    temperature: object  # of the gas [K], a function of points
    formula: str  # the same in a case file
    absorption: float  # [1/m]
    scattering: float = 0.0  # [1/m], isotropic
    emissivity: float = 1.0  # of the walls
    wall_temperature: float = 0.0  # [K]

    def radiance(self, points):
        """Radiance of a blackbody at the temperature of the gas [W/(m^2 sr)]."""
        return STEFAN_BOLTZMANN / numpy.pi * self.temperature(points) ** 4


SCENES = [
    *(Scene(f"uniform {kappa:g}", uniform, "1500", kappa) for kappa in (0.1, 1.0, 10.0)),
    *(Scene(f"flame {kappa:g}", flame, FLAME, kappa) for kappa in (0.1, 1.0, 10.0)),
    Scene("scattering", flame, FLAME, 0.2, 2.0, 0.8, 500.0),
]
