# SPDX-License-Identifier: AGPL-3.0-or-later
"""Heat fluxes into the black, cold walls of a box by integration along rays, and means over wall faces.

The flux at a wall point is the integral over azimuth, polar angle and distance; each of the four side walls and the
opposite wall is a smooth piece of it. A table of Chebyshev points on each wall is interpolated to other points: the
coordinate t of x = t^2 (3 - 2 t) makes the flux smooth at the edges of the wall."""

import numpy

from fvdom.scenes import SIDES

TABLE = 28  # points of the table along each side of a wall
NODES = (28, 24, 32)  # of azimuth, polar angle and distance, for each piece
SPACING = 0.03  # of the points that face means are taken from [m]

# Dunavant's rule of degree 5 on a triangle: barycentric coordinates and weights.
_A, _B = (6 - 15**0.5) / 21, (6 + 15**0.5) / 21
TRIANGLE_POINTS = numpy.array([[1 / 3] * 3] + [numpy.roll([1 - 2 * p, p, p], i) for p in (_A, _B) for i in range(3)])
TRIANGLE_WEIGHTS = numpy.array([9 / 40] + [(155 - 15**0.5) / 1200] * 3 + [(155 + 15**0.5) / 1200] * 3)


def gauss(count):
    """Nodes and weights of Gauss and Legendre on [0, 1]."""
    nodes, weights = numpy.polynomial.legendre.leggauss(count)
    return (nodes + 1) / 2, weights / 2


def graded(count):
    """Nodes and weights on [0, 1] that are dense at both ends."""
    t, weights = gauss(count)
    return t**3 * (10 - 15 * t + 6 * t**2), weights * 30 * (t * (1 - t)) ** 2


def mean_radiance(scene, origins, directions, lengths, nodes):
    """Radiance that arrives at the origins from along rays of these lengths."""
    if scene.formula.isdigit():
        return scene.radiance(origins) * -numpy.expm1(-scene.absorption * lengths)
    steps, weights = gauss(nodes)
    total = numpy.zeros(lengths.shape)
    for step, weight in zip(steps, weights):
        distance = step * lengths
        emitted = scene.radiance(origins + distance[..., None] * directions)
        total += weight * emitted * numpy.exp(-scene.absorption * distance)
    return total * scene.absorption * lengths


def flux_at(scene, axis, high, point, nodes=NODES):
    """Heat flux [W/m^2] into the wall across an axis (at its high or low end) at one of its points."""
    height = SIDES[axis]
    normal = numpy.zeros(3)
    normal[axis] = -1.0 if high else 1.0
    across = [a for a in range(3) if a != axis]
    distances = [(a, side, SIDES[a] - point[a] if side > 0 else point[a]) for a in across for side in (1, -1)]
    azimuth, azimuth_weights = graded(nodes[0])
    polar, polar_weights = graded(nodes[1])
    total = 0.0
    for along, side, distance in distances:
        other = next(a for a in across if a != along)
        first = -numpy.arctan2(point[other], distance)
        last = numpy.arctan2(SIDES[other] - point[other], distance)
        phi = first + (last - first) * azimuth
        horizontal = numpy.zeros((len(phi), 3))
        horizontal[:, along], horizontal[:, other] = side * numpy.cos(phi), numpy.sin(phi)
        reach = (distance / numpy.cos(phi))[:, None]
        widest = numpy.arctan2(reach, height)
        for begin, end, opposite in ((0 * widest, widest, True), (widest, 0 * widest + numpy.pi / 2, False)):
            theta = begin + (end - begin) * polar
            lengths = height / numpy.cos(theta) if opposite else reach / numpy.sin(theta)
            directions = (numpy.sin(theta)[..., None] * horizontal[:, None, :] + numpy.cos(theta)[..., None] * normal)
            seen = mean_radiance(scene, numpy.broadcast_to(point, directions.shape), directions, lengths, nodes[2])
            inner = (seen * numpy.sin(theta) * numpy.cos(theta) * polar_weights).sum(axis=1) * (end - begin)[:, 0]
            total += (last - first) * (azimuth_weights * inner).sum()
    return total


def chebyshev(count):
    """Chebyshev points on [0, 1], and their barycentric weights."""
    angles = (2 * numpy.arange(count) + 1) * numpy.pi / (2 * count)
    return (1 - numpy.cos(angles)) / 2, (-1.0) ** numpy.arange(count) * numpy.sin(angles)


def interpolation(count, t):
    """Matrix that takes values at Chebyshev points to the points t."""
    nodes, weights = chebyshev(count)
    difference = t[:, None] - nodes
    difference[difference == 0] = 1e-300
    terms = weights / difference
    return terms / terms.sum(axis=1, keepdims=True)


def side_to_t(x):
    """Inverse of x = t^2 (3 - 2 t) on [0, 1]."""
    return 0.5 - numpy.sin(numpy.arcsin(numpy.clip(1 - 2 * x, -1, 1)) / 3)


class ExactFlux:
    """Wall flux of a scene without scattering. It is symmetric about x = y = 1/2, so three walls are computed."""

    def __init__(self, scene, count=TABLE, nodes=NODES):
        self.scene, self.count = scene, count
        t, _ = chebyshev(count)
        x = t**2 * (3 - 2 * t)
        self.tables = {wall: self._table(wall, x, nodes) for wall in ((0, False), (2, False), (2, True))}

    def _table(self, wall, x, nodes):
        axis, high = wall
        first, second = [a for a in range(3) if a != axis]
        half = (self.count + 1) // 2
        table = numpy.empty((self.count, self.count))
        for i in range(half):
            for j in range(self.count):
                point = numpy.zeros(3)
                point[axis] = SIDES[axis] if high else 0
                point[first], point[second] = SIDES[first] * x[i], SIDES[second] * x[j]
                table[i, j] = table[-1 - i, j] = flux_at(self.scene, axis, high, point, nodes)
        return table

    def at(self, axis, high, points):
        """Fluxes [W/m^2] at points [n, 3] of one wall."""
        first, second = [a for a in range(3) if a != axis]
        table = self.tables[(axis, high) if axis == 2 else (0, False)]
        left = interpolation(self.count, side_to_t(points[:, first] / SIDES[first]))
        right = interpolation(self.count, side_to_t(points[:, second] / SIDES[second]))
        return numpy.einsum("ni,ij,nj->n", left, table, right, optimize=True)


class ComputedFlux:
    """Wall flux of a finer solution: triangles [n, 3, 3] and the fluxes at their corners [n, 3]."""

    def __init__(self, triangles, fluxes):
        from matplotlib.tri import Triangulation
        self.walls = {}
        walls = walls_of(triangles)
        for wall in sorted(set(walls)):
            mine = numpy.array([w == wall for w in walls])
            plane = [a for a in range(3) if a != wall[0]]
            corners = triangles[mine][:, :, plane]
            points, index = numpy.unique(corners.reshape(-1, 2).round(9), axis=0, return_inverse=True)
            finder = Triangulation(*points.T, index.reshape(-1, 3)).get_trifinder()
            self.walls[wall] = plane, corners, fluxes[mine], finder

    def at(self, axis, high, points):
        plane, corners, fluxes, finder = self.walls[axis, high]
        at = points[:, plane]
        found = finder(*at.T)
        if (found < 0).any():
            raise RuntimeError("a wall point is in no face of the reference")
        a, b, c = (corners[found, i] for i in range(3))
        (ux, uy), (vx, vy), (wx, wy) = (b - a).T, (c - a).T, (at - a).T
        area = ux * vy - uy * vx
        second, third = (wx * vy - wy * vx) / area, (ux * wy - uy * wx) / area
        return (fluxes[found] * numpy.stack([1 - second - third, second, third], axis=1)).sum(axis=1)


def walls_of(faces):
    """The wall (axis, high end) of each face [n, corners, 3] on the boundary of the box."""
    centers = faces.mean(axis=1)
    gaps = numpy.concatenate([abs(centers), abs(centers - SIDES)], axis=1)
    nearest = gaps.argmin(axis=1)
    return [(int(n) % 3, bool(n >= 3)) for n in nearest]


def composite_rule(parts):
    """Barycentric points and weights of the rule on each of the parts^2 equal triangles that divide a triangle."""
    corners = []
    for i in range(parts):
        for j in range(parts - i):
            corners.append([(i, j), (i + 1, j), (i, j + 1)])
            if i + j < parts - 1:
                corners.append([(i + 1, j), (i + 1, j + 1), (i, j + 1)])
    corners = numpy.array(corners) / parts
    plane = numpy.einsum("qk,tkd->tqd", TRIANGLE_POINTS, corners).reshape(-1, 2)
    points = numpy.concatenate([1 - plane.sum(axis=1, keepdims=True), plane], axis=1)
    return points, numpy.tile(TRIANGLE_WEIGHTS, parts**2) / parts**2


def areas_and_means(flux, faces, spacing=SPACING):
    """Areas of plane wall faces [n, corners, 3], and the mean of a flux over each.

    Faces are divided into triangles as small as the spacing: at the edges of the box the flux has steep layers."""
    areas, integrals = numpy.zeros(len(faces)), numpy.zeros(len(faces))
    longest = numpy.linalg.norm(faces - numpy.roll(faces, 1, axis=1), axis=2).max()
    rule_points, rule_weights = composite_rule(int(numpy.ceil(longest / spacing)))
    walls = walls_of(faces)
    for wall in sorted(set(walls)):
        mine = numpy.flatnonzero([w == wall for w in walls])
        for corner in range(1, faces.shape[1] - 1):
            triangles = faces[mine][:, [0, corner, corner + 1]]
            area = numpy.linalg.norm(numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]),
                                     axis=1) / 2
            points = numpy.einsum("qk,nkd->nqd", rule_points, triangles)
            values = flux.at(*wall, points.reshape(-1, 3)).reshape(len(mine), -1)
            areas[mine] += area
            integrals[mine] += area * (values @ rule_weights)
    return areas, integrals / areas


def coarsened(triangles, fluxes, faces):
    """Means over the triangular faces of a coarse mesh, whose walls the given triangles with their fluxes divide."""
    number = ComputedFlux(faces, numpy.repeat(numpy.arange(len(faces), dtype=float), 3).reshape(-1, 3))
    centers = triangles.mean(axis=1)
    parent, walls = numpy.zeros(len(triangles), dtype=int), walls_of(triangles)
    for wall in sorted(set(walls)):
        mine = numpy.flatnonzero([w == wall for w in walls])
        parent[mine] = numpy.rint(number.at(*wall, centers[mine])).astype(int)
    areas = numpy.linalg.norm(numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)
    return numpy.bincount(parent, areas * fluxes.mean(axis=1)) / numpy.bincount(parent, areas)


def errors(faces, fluxes, reference):
    """L2 error of the face means over the RMS flux, and relative error of the net power; reference: areas, means."""
    areas, means = reference
    error = ((areas * (fluxes - means) ** 2).sum() / (areas * means**2).sum()) ** 0.5
    return error, (areas * fluxes).sum() / (areas * means).sum() - 1
