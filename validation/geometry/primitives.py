# SPDX-License-Identifier: AGPL-3.0-or-later
"""Boxes, spheres, cylinders, sheets and patches whose coordinates are often those of earlier ones, but for a gap."""

import math

from geometry import convex, volumes

ROOM = (4.0, 3.0, 2.5)
REGIONS = ("a", "b", "c")
AXES = range(3)
THINNEST = 1e-7  # of the size: thinner boxes are refused before they are meshed


def boxes(scene):
    _add_room(scene)
    for _ in range(scene.draw.integer(1, 5)):
        _add_box(scene)
    _add_patches(scene)
    _finish(scene)


def bodies(scene):
    _add_room(scene)
    for _ in range(scene.draw.integer(1, 4)):
        _add_body(scene)
    _finish(scene)


def needles(scene):
    """Bodies, one or two of them 1e-6 to 1e-1 of the room wide."""
    _add_room(scene)
    for number in range(scene.draw.integer(1, 3)):
        width = scene.size * 10 ** scene.draw.number(-6, -1) if number < 2 else None
        scene.draw.one_of((_add_box, _add_cylinder, _add_sphere))(scene, width)
    _finish(scene)


def nested(scene):
    """Each body in the one before it, or a little larger, around one middle."""
    draw = scene.draw
    _add_room(scene)
    middle, half = [draw.number(0.3, 0.7) * extent for extent in ROOM], draw.number(0.3, 1.0)
    for _ in range(draw.integer(2, 4)):
        kind = draw.integer(0, 2)
        if kind == 0:
            _add(scene, "box", {"min": [m - half for m in middle], "max": [m + half for m in middle]})
        elif kind == 1:
            _add(scene, "sphere", {"center": middle, "radius": half, "facets": draw.one_of((20, 80, 320))})
        else:
            start, end, axis = list(middle), list(middle), draw.integer(0, 2)
            start[axis] -= half
            end[axis] += half
            _add(scene, "cylinder", {"from": start, "to": end, "radius": half, "facets": draw.integer(3, 24)})
        half *= draw.number(0.4, 0.95) if draw.chance(0.4) else 1
        half -= scene.gap()
    _finish(scene)


def parts(scene):
    """No room: bodies beside each other, of several parts, at any scale and far from the origin."""
    draw = scene.draw
    for axis in AXES:
        scene.known[axis] = [0.0, 1.0]
    for number in range(draw.integer(2, 5)):
        _add_body(scene, hole=False if number == 0 else None)
    _place(scene, 10.0 ** draw.integer(-6, 6), draw.one_of((0, 0, 1, 100, 1e4)))
    _finish(scene)


def sheets(scene):
    """Bodies and sheets of all kinds between them."""
    _add_room(scene)
    for _ in range(scene.draw.integer(0, 2)):
        _add_body(scene)
    for number in range(scene.draw.integer(1, 4)):
        _add_sheet(scene, f"s{number}")
    _finish(scene)


KINDS = {"boxes": boxes, "bodies": bodies, "needles": needles, "nested": nested, "parts": parts, "sheets": sheets}


def _add_room(scene):
    scene.size = max(ROOM)
    scene.bodies.append(("box", {"region": "room", "min": [0.0, 0.0, 0.0], "max": list(ROOM)}))
    for axis in AXES:
        scene.known[axis] = [0.0, ROOM[axis]]


def _add(scene, shape, entry, hole=None):
    """A body of a region, or a hole."""
    draw = scene.draw
    hole = draw.chance(0.25) if hole is None else hole
    named = {"hole": True, "name": f"h{len(scene.bodies)}"} if hole else {"region": draw.one_of(REGIONS)}
    scene.bodies.append((shape, named | entry))


def _width(scene):
    return scene.size * scene.draw.logarithmic(0.02, 0.3)


def _place_of(scene):
    extent = ROOM if scene.size == max(ROOM) else (1.0, 1.0, 1.0)
    return [scene.coordinate(axis, 0, extent[axis]) for axis in AXES]


def _add_box(scene, width=None, hole=None):
    low, high = _place_of(scene), []
    thin = scene.draw.integer(1, 6)  # bits: the axes along which it is narrow
    for axis in AXES:
        narrow = width and thin >> axis & 1
        far = low[axis] + (width if narrow else _width(scene))
        if not narrow and scene.draw.chance(0.5):
            far = scene.coordinate(axis, low[axis], low[axis] + 2 * _width(scene))
        scene.known[axis].append(far)
        if abs(far - low[axis]) < THINNEST * scene.size:
            far = low[axis] + _width(scene)
        low[axis], far = sorted((low[axis], far))
        high.append(far)
    _add(scene, "box", {"min": low, "max": high}, hole)


def _add_sphere(scene, width=None, hole=None):
    radius = (width or _width(scene)) / 2
    _add(scene, "sphere", {"center": _place_of(scene), "radius": radius,
                           "facets": scene.draw.one_of((20, 80, 320))}, hole)


def _add_cylinder(scene, width=None, hole=None):
    draw, start = scene.draw, _place_of(scene)
    axis, length = draw.integer(0, 2), _width(scene)
    along = [float(axis == k) for k in AXES]
    if draw.chance(0.25):
        along = [0.6, 0, 0.8]
    elif draw.chance(0.2):
        along = draw.direction()
    end = [s + length * part for s, part in zip(start, along)]
    if draw.chance(0.3):
        end[axis] = scene.coordinate(axis, end[axis], end[axis] + length)
    _add(scene, "cylinder", {"from": start, "to": end, "radius": (width or _width(scene)) / 2,
                             "facets": draw.integer(3, 24)}, hole)


def _add_body(scene, hole=None):
    scene.draw.one_of((_add_box, _add_box, _add_sphere, _add_cylinder))(scene, None, hole)


def _add_patches(scene):
    draw = scene.draw
    for number in range(draw.integer(0, 2)):
        axis, low, high = draw.integer(0, 2), _place_of(scene), _place_of(scene)
        low, high = [min(a, b) for a, b in zip(low, high)], [max(a, b) for a, b in zip(low, high)]
        low[axis] = high[axis] = draw.one_of((0.0, ROOM[axis]))
        scene.bodies.append(("patch", {"wall": f"p{number}", "min": low, "max": high}))


def _add_sheet(scene, name):
    draw, low, high = scene.draw, _place_of(scene), _place_of(scene)
    low, high = [min(a, b) for a, b in zip(low, high)], [max(a, b) for a, b in zip(low, high)]
    axis = draw.integer(0, 2)
    if draw.chance(0.7):  # in the room, wherever the rest is
        low[axis] = min(max(low[axis], 0.0), ROOM[axis]) if draw.chance(0.3) else draw.number(0.05, 0.95) * ROOM[axis]
    for other in AXES:
        if other != axis and high[other] - low[other] < THINNEST * scene.size:
            high[other] = low[other] + _width(scene)
    if draw.chance(0.5):
        high[axis] = low[axis]
        entry = {"min": low, "max": high}
    elif draw.chance(0.5):
        (x, y, z), (X, Y, Z) = low, high
        entry = {"corners": [[x, y, z], [X, y, z], [X, Y, Z], [x, Y, Z]][:draw.integer(3, 4)]}
    else:
        entry = {"corners": _star(scene, axis, low, high)}
    scene.bodies.append(("sheet", entry | {"front": f"{name}.front", "back": f"{name}.back"}))


def _star(scene, axis, low, high):
    """A polygon across an axis, now and then not convex, with a corner nearly on an edge of the room."""
    draw, count = scene.draw, scene.draw.integer(3, 9)
    (i, j), corners = [k for k in AXES if k != axis], []
    for corner in range(count):
        angle, reach = 2 * math.pi * corner / count, draw.number(0.2, 1)
        point = [low[axis]] * 3
        point[i] = (low[i] + high[i]) / 2 + reach * (high[i] - low[i]) / 2 * math.cos(angle)
        point[j] = (low[j] + high[j]) / 2 + reach * (high[j] - low[j]) / 2 * math.sin(angle)
        corners.append(point)
    return corners


def _place(scene, scale, distance):
    """Scales all and moves it by so many sizes."""
    for _, entry in scene.bodies:
        for key in ("min", "max", "center", "from", "to"):
            if key in entry:
                entry[key] = [scale * (x + distance) for x in entry[key]]
        if "radius" in entry:
            entry["radius"] *= scale
    scene.size *= scale


def _finish(scene):
    primitives = [body for body in scene.bodies if body[0] in ("box", "sphere", "cylinder")]
    regions = [entry.get("region") for _, entry in primitives]

    def find():
        if all(shape == "box" for shape, _ in primitives):
            return volumes.exact_boxes([(entry["min"], entry["max"]) for _, entry in primitives],
                                       lambda around: regions[max(around)] if around else None)
        return volumes.by_lines([_convex(*primitive) for primitive in primitives], max,
                                lambda around: regions[max(around)], scene.seed)
    scene.volumes = find


def _convex(shape, entry):
    if shape == "box":
        return convex.box(entry["min"], entry["max"])
    if shape == "sphere":
        return convex.sphere(entry["center"], entry["radius"], entry["facets"])
    return convex.cylinder(entry["from"], entry["to"], entry["radius"], entry["facets"])
