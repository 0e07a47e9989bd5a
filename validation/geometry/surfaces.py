# SPDX-License-Identifier: AGPL-3.0-or-later
"""Closed shells in, beside and across each other, and open sheets among them, in surface files."""

import numpy

from geometry import convex, volumes
from geometry.surface_text import add_surface, surface_text

AXES = range(3)


def add_shells(scene):
    """Closed shells, each in, beside or across one before it."""
    found = random_shells(scene.draw, scene.gap)
    ending = scene.draw.one_of(("stl", "obj", "off", "ply", "smesh"))
    add_surface(scene, ending, *joined(found))
    if ending == "smesh":
        label = _all_one
    elif scene.draw.chance(0.3):
        label = _seeded(scene, found)
    else:
        label = _by_turns
    sizes = [float(numpy.prod(shell.high - shell.low)) for shell in found]

    def smallest(around):
        return min(around, key=lambda number: (sizes[number], number))
    scene.volumes = lambda: volumes.by_lines(found, smallest, label, scene.seed)


def add_open_sheets(scene):
    """Shells, and a triangle or rectangle with an edge of its own."""
    add_shells(scene)
    name = scene.mesh["surface"]
    if name.endswith("smesh"):
        return
    draw, points = scene.draw, []
    start = [draw.number(0.1, 0.9) for _ in AXES]
    sides = [[draw.one_of((draw.number(-0.5, 0.5), scene.gap(), 0.0)) for _ in AXES] for _ in range(2)]
    for first, second in ((0, 0), (1, 0), (1, 1), (0, 1)):
        points.append([s + first * a + second * b for s, a, b in zip(start, *sides)])
    scene.files[name] = _appended(scene.files[name], name.rpartition(".")[2], points)


def _appended(text, ending, points):
    """A file with another rectangle in it; only of STL and OBJ, which are lists without counts."""
    count = text.count("\nv ") + text.startswith("v ")
    if ending == "obj":
        moved = [None] * count + points
        body = "".join("v " + " ".join(map(repr, map(float, p))) + "\n" for p in points)
        return text + body + "g sheet\nf " + " ".join(str(k + 1) for k in range(count, len(moved))) + "\n"
    if ending == "stl":
        return text + surface_text("stl", points, [(0, 1, 2), (0, 2, 3)]).replace("body", "sheet")
    return text


def random_shells(draw, gap):
    """One to four; `gap` gives the distances that some of them nearly touch at."""
    found = [_shell(draw, numpy.full(3, 0.5), 0.5)]
    for _ in range(draw.integer(0, 3)):
        other = draw.one_of(found)
        relation = draw.integer(0, 3)
        extent = other.high - other.low
        if relation == 0:    # a copy a little smaller: nearly coincident all around
            factor = 1 - 2 * abs(gap()) if draw.chance(0.5) else draw.number(0.3, 0.95)
            found.append(other.moved(factor, [0, 0, 0]))
        elif relation == 1:  # a copy beside it, across a gap
            shift, axis = numpy.zeros(3), draw.integer(0, 2)
            shift[axis] = extent[axis] + gap()
            found.append(other.moved(1, shift))
        elif relation == 2:  # in it, its top nearly that of the other one
            inner = _shell(draw, (other.low + other.high) / 2, float(extent.min()) * draw.number(0.05, 0.3))
            found.append(inner.moved(1, [0, 0, other.high[2] - inner.high[2] - abs(gap())]))
        else:
            found.append(_shell(draw, numpy.array([draw.number(0, 1) for _ in AXES]), draw.logarithmic(1e-3, 0.3)))
    return found


def _shell(draw, middle, half):
    kind = draw.integer(0, 3)
    if kind == 0:
        return convex.sphere(middle, half, draw.one_of((20, 80, 320)))
    if kind == 1:
        stretch = draw.one_of((1.0, 1.0, draw.logarithmic(1e-4, 1)))
        end = numpy.array([0, 0, half * stretch])
        return convex.cylinder(middle - end, middle + end, half, draw.integer(3, 20))
    return convex.box(middle - half, middle + half)


def joined(found):
    """Points and polygons of all."""
    points, polygons = [], []
    for shell in found:
        first = len(points)
        points += [tuple(map(float, point)) for point in shell.points]
        polygons += [[first + corner for corner in face] for face in shell.faces]
    return points, polygons


def _all_one(_):
    return "domain"


def _by_turns(around):
    return "domain" if len(around) % 2 else None


def _seeded(scene, found):
    """Points of regions, one or two; a region is the part around the same shells as its point."""
    draw, regions = scene.draw, {}
    for name in ("a", "b")[:draw.integer(1, 2)]:
        shell = draw.one_of(found)
        share = numpy.array([draw.number(0.05, 0.95) for _ in AXES])
        regions[name] = [float(x) for x in shell.low + share * (shell.high - shell.low)]
    scene.mesh["regions"] = regions
    planes = [shell.planes() for shell in found]
    parts = {}
    for name, point in regions.items():
        turned = [point[0], point[2], -point[1]] if scene.mesh.get("up") == "y" else point
        parts[tuple(k for k, (normals, offsets) in enumerate(planes) if (normals @ turned < offsets).all())] = name
    return lambda around: parts.get(tuple(around))


KINDS = {"shells": add_shells, "open sheets": add_open_sheets}
