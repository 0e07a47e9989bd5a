# SPDX-License-Identifier: AGPL-3.0-or-later
"""Surface files with damage as other programs make it: lost, flipped, doubled and torn polygons, strange numbers."""

from geometry.surface_text import add_surface
from geometry.surfaces import joined, random_shells
from geometry.tunnels import block_with, random_hole


def add_damaged(scene):
    """Meshed or refused, but the volume is not known."""
    draw = scene.draw
    if draw.chance(0.5):
        made = joined(random_shells(draw, scene.gap))
    else:
        made = block_with([random_hole(scene, 0, 1)], [1.0, 1.0, 1.0])
    points, polygons = [list(point) for point in made[0]], [list(polygon) for polygon in made[1]]
    for _ in range(draw.integer(1, 2)):
        draw.one_of(DAMAGES)(scene, points, polygons)
    add_surface(scene, draw.one_of(("stl", "obj", "off", "ply", "smesh")), points, polygons)
    name = scene.mesh["surface"]
    if draw.chance(0.1):
        text = scene.files[name]
        scene.files[name] = text[:int(len(text) * draw.number(0, 1))]


def _lose(scene, points, polygons):
    polygons.pop(scene.draw.integer(0, len(polygons) - 1))


def _flip(scene, points, polygons):
    scene.draw.one_of(polygons).reverse()


def _double(scene, points, polygons):
    polygons.append(list(scene.draw.one_of(polygons)))


def _crack(scene, points, polygons):
    """One polygon has a corner of its own, next to that of the others."""
    polygon = scene.draw.one_of(polygons)
    place = scene.draw.integer(0, len(polygon) - 1)
    points.append([x + scene.gap() for x in points[polygon[place]]])
    polygon[place] = len(points) - 1


def _needle(scene, points, polygons):
    """A triangle with two corners on one edge of a polygon."""
    polygon = scene.draw.one_of(polygons)
    a, b = points[polygon[0]], points[polygon[1]]
    points.append([(p + q) / 2 + scene.gap() for p, q in zip(a, b)])
    polygons.append([polygon[1], polygon[0], len(points) - 1])


def _move(scene, points, polygons):
    point = scene.draw.one_of(points)
    point[scene.draw.integer(0, 2)] += scene.draw.one_of((scene.gap(), scene.draw.number(-1, 1)))


def _spoil(scene, points, polygons):
    strange = (1e300, -1e200, 1e-300, float("nan"), float("inf"))
    scene.draw.one_of(points)[scene.draw.integer(0, 2)] = scene.draw.one_of(strange)


def _twist(scene, points, polygons):
    """Two corners of a polygon change places, so that it crosses itself."""
    polygon = scene.draw.one_of(polygons)
    polygon[0], polygon[1] = polygon[1], polygon[0]


DAMAGES = (_lose, _flip, _double, _crack, _needle, _move, _spoil, _twist)


KINDS = {"damaged": add_damaged}
