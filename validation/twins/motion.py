# SPDX-License-Identifier: AGPL-3.0-or-later
"""Motions x' = s R x + t of a scene, with R orthogonal: rotations, mirrors, shifts and changes of scale."""

import dataclasses
import itertools
import math
import re

import numpy

AXES = "xyz"
# Coordinates of the place, of the direction of travel, and of that after scattering.
NAMES = re.compile(r"\b([wv]?)([xyz])\b")


@dataclasses.dataclass
class Motion:
    matrix: numpy.ndarray
    scale: float = 1.0
    shift: tuple = (0.0, 0.0, 0.0)
    rotation: dict = dataclasses.field(default_factory=dict)  # of the direction set, as its key of the case file says it

    @property
    def mirrors(self):
        return numpy.linalg.det(self.matrix) < 0

    def places(self, points):
        return self.scale * (points @ self.matrix.T) + self.shift

    def place(self, point):
        return self.places(numpy.array(point, float)).tolist()

    def direction(self, vector):
        return (self.matrix @ numpy.array(vector, float)).tolist()

    def formula(self, text):
        """A formula of the scene for the moved one: old coordinates by new ones."""
        return NAMES.sub(lambda name: self._old(*name.groups()), text)

    def _old(self, kind, axis):
        row = self.matrix[:, AXES.index(axis)]
        shift = (0.0, 0.0, 0.0) if kind else self.shift
        terms = [f"({part!r}) * ({kind}{new} - ({offset!r}))" for part, new, offset in
                 zip(row.tolist(), AXES, map(float, shift)) if part]
        return f"(({' + '.join(terms)}) / {1.0 if kind else self.scale!r})"


def rotated_by_90(draw, upright):
    """One of the rotations other than the identity that take the axes to axes; `upright` ones keep that of z."""
    return Motion(_axes_to_axes(draw, upright, 1))


def mirrored(draw, upright):
    """One of the mirrors, and mirrors with rotations, that take the axes to axes."""
    return Motion(_axes_to_axes(draw, upright, -1))


def scaled(factor):
    return Motion(numpy.eye(3), factor)


def rotated(draw, upright):
    """A rotation by any angle with a shift; `upright` ones keep the axis of z."""
    axis = [0, 0, draw.one_of((-1, 1))] if upright else draw.direction()
    angle = draw.number(5, 355)
    shift = tuple(draw.number(-2, 2) for _ in range(3))
    return Motion(rotation_matrix(axis, math.radians(angle)), 1.0, shift, {"axis": axis, "angle": angle})


def rotation_matrix(axis, angle):
    """By Rodrigues' formula, counterclockwise as seen from the tip of the axis."""
    x, y, z = numpy.array(axis) / numpy.linalg.norm(axis)
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def _axes_to_axes(draw, upright, determinant):
    found = []
    for order, signs in itertools.product(itertools.permutations(range(3)), itertools.product((1.0, -1.0), repeat=3)):
        matrix = numpy.diag(signs)[list(order)]
        fits = round(numpy.linalg.det(matrix)) == determinant and not numpy.array_equal(matrix, numpy.eye(3))
        if fits and (not upright or order[2] == 2):
            found.append(matrix)
    return draw.one_of(found)
