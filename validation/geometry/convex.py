# SPDX-License-Identifier: AGPL-3.0-or-later
"""Convex polyhedra: those that the program makes of boxes, spheres and cylinders, and the shells of surface files."""

import dataclasses
import math

import numpy


@dataclasses.dataclass
class Convex:
    """Corners and polygons, counterclockwise from outside."""

    points: numpy.ndarray  # [corner, 3]
    faces: list            # of numbers of corners

    @property
    def low(self):
        return self.points.min(axis=0)

    @property
    def high(self):
        return self.points.max(axis=0)

    def planes(self):
        """Outward normals and offsets: a point x is inside where normals @ x <= offsets."""
        corners = [self.points[list(face[:3])] for face in self.faces]
        normals = numpy.array([numpy.cross(b - a, c - a) for a, b, c in corners])
        normals /= numpy.linalg.norm(normals, axis=1)[:, None]
        return normals, numpy.array([normal @ a for normal, (a, _, _) in zip(normals, corners)])

    def moved(self, factor, shift):
        """Scaled around its middle and moved."""
        middle = (self.low + self.high) / 2
        return Convex(middle + factor * (self.points - middle) + numpy.asarray(shift), self.faces)


def box(low, high):
    points = [[(low, high)[corner >> axis & 1][axis] for axis in range(3)] for corner in range(8)]
    faces = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return Convex(numpy.array(points, float), faces)


def sphere(center, radius, facets):
    """The icosahedron with each edge in n parts, 20 n^2 nearest to `facets`."""
    parts = 1
    while 10 * ((parts + 1) ** 2 + parts ** 2) <= facets:
        parts += 1
    corners, numbers, points, faces = _icosahedron(), {}, [], []

    def vertex(face, i, j):
        mix = tuple(sorted((c, n) for c, n in zip(face, (parts - i - j, i, j)) if n))
        if mix not in numbers:
            numbers[mix] = len(points)
            direction = sum(n * corners[c] for c, n in mix)
            points.append(numpy.asarray(center) + radius * direction / numpy.linalg.norm(direction))
        return numbers[mix]

    for face in _icosahedron_faces(corners):
        for i in range(parts):
            for j in range(parts - i):
                faces.append((vertex(face, i, j), vertex(face, i + 1, j), vertex(face, i, j + 1)))
                if i + j + 1 < parts:
                    faces.append((vertex(face, i + 1, j), vertex(face, i + 1, j + 1), vertex(face, i, j + 1)))
    return Convex(numpy.array(points), faces)


def _icosahedron():
    golden, corners = (1 + math.sqrt(5)) / 2, []
    for axis in range(3):
        for one in (-1, 1):
            for other in (-golden, golden):
                corner = numpy.zeros(3)
                corner[(axis + 1) % 3], corner[(axis + 2) % 3] = one, other
                corners.append(corner)
    return corners


def _icosahedron_faces(corners):
    def near(a, b):
        return numpy.linalg.norm(corners[a] - corners[b]) < 2.1
    triples = [(a, b, c) for a in range(12) for b in range(a + 1, 12) for c in range(b + 1, 12)
               if near(a, b) and near(b, c) and near(c, a)]
    return [(a, b, c) if corners[a] @ numpy.cross(corners[b], corners[c]) > 0 else (a, c, b) for a, b, c in triples]


def cylinder(start, end, radius, sides):
    """The regular prism whose first corner lies where the program has it."""
    start, end = numpy.array(start, float), numpy.array(end, float)
    across = _across(end - start)
    ring = [start + radius * (math.cos(a) * across[0] + math.sin(a) * across[1])
            for a in (2 * math.pi * i / sides for i in range(sides))]
    points = numpy.array(ring + [point + end - start for point in ring])
    walls = [(i, (i + 1) % sides, sides + (i + 1) % sides, sides + i) for i in range(sides)]
    return Convex(points, [*walls, tuple(reversed(range(sides))), tuple(range(sides, 2 * sides))])


def _across(axis):
    """Two unit vectors that complete an axis to a right-handed frame, as Eigen's unitOrthogonal() takes them."""
    x, y, z = axis
    if numpy.count_nonzero(axis) == 1:
        i = int(numpy.flatnonzero(axis)[0])
        first, second = numpy.eye(3)[(i + 1) % 3], numpy.eye(3)[(i + 2) % 3]
        return (first, second) if axis[i] > 0 else (second, first)
    small = 1e-12 * abs(z)
    first = numpy.array([-y, x, 0] if abs(x) > small or abs(y) > small else [0, -z, y], float)
    first /= numpy.linalg.norm(first)
    return first, numpy.cross(axis / numpy.linalg.norm(axis), first)
