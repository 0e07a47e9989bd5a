# SPDX-License-Identifier: AGPL-3.0-or-later
"""Blocks with tunnels, whose ends are polygons with holes: outlines that go along a bridge to each hole and back."""

import math

from geometry.surface_text import add_surface
from geometry.volumes import Volume


def add_tunnels(scene):
    draw = scene.draw
    size = [1.0, 1.0, draw.one_of((1.0, draw.logarithmic(1e-3, 10)))]
    count = draw.integer(1, 4)
    holes = [random_hole(scene, number, count) for number in range(count)]
    points, polygons = block_with(holes, size)
    add_surface(scene, draw.one_of(("obj", "off", "ply")), points, polygons)
    inside = size[0] * size[1] - sum(map(_area, holes))
    scene.volumes = lambda: {"domain": Volume(inside * size[2], 0.0, 6.0)}


def random_hole(scene, number, count):
    """A polygon in its part of the row, which it fills but for a gap or more; clockwise, from its lowest corner on."""
    draw = scene.draw
    low, high = number / count, (number + 1) / count
    margin = draw.one_of((abs(scene.gap()), draw.number(0.02, 0.3) / count))
    margin = max(margin, 1e-13)
    x0, x1 = low + margin, high - margin
    y0, y1 = draw.one_of((margin, 0.1, 0.4)), draw.one_of((1 - margin, 0.9, 0.6))
    sides = draw.integer(3, 12)
    if draw.chance(0.5):
        return [((x0 + x1) / 2, y0), (x0, (y0 + y1) / 2), ((x0 + x1) / 2, y1), (x1, (y0 + y1) / 2)]
    return [((x0 + x1) / 2 - (x1 - x0) / 2 * math.sin(2 * math.pi * k / sides),
             (y0 + y1) / 2 - (y1 - y0) / 2 * math.cos(2 * math.pi * k / sides)) for k in range(sides)]


def _area(polygon):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(polygon, [*polygon[1:], polygon[0]]))) / 2


def block_with(holes, size):
    """Points and polygons of the block; below each hole its outline has a corner, where the bridge begins."""
    a, b, height = size
    outline = [(0.0, 0.0), *((hole[0][0], 0.0) for hole in holes), (a, 0.0), (a, b), (0.0, b)]
    flat = [*outline, *(corner for hole in holes for corner in hole)]
    points = [(x, y, z) for z in (0.0, height) for x, y in flat]
    top, first, walls = [0], len(outline), []
    for number, hole in enumerate(holes):
        ring = list(range(first, first + len(hole)))
        top += [number + 1, *ring, ring[0], number + 1]
        walls += list(zip(ring, [*ring[1:], ring[0]]))
        first += len(hole)
    top += range(len(holes) + 1, len(outline))
    walls += [(k, (k + 1) % len(outline)) for k in range(len(outline))]
    sides = [(p, q, q + len(flat), p + len(flat)) for p, q in walls]
    return points, [[len(flat) + p for p in top], list(reversed(top)), *sides]


KINDS = {"tunnels": add_tunnels}
