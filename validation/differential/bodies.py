# SPDX-License-Identifier: AGPL-3.0-or-later
"""The geometry of a scene: a room and, in eighths of it, bodies of other media, holes and sheets."""

import itertools
import math

from differential.slot import Slot

CELLS = 500  # of the largest volume; TetGen makes two to six times as many
# Of a cube as wide as a body, in the run with finer cells in bodies: about half as long as the edges of their facets.
BODY_CELLS = {"block": 64, "ball": 500, "rod": 500}
SIDES = ("xmin", "xmax", "ymin", "ymax", "zmin", "zmax")
KINDS = ("block", "ball", "rod", "crate", "chest", "stone", "pillar", "sheet", "slanted sheet")


def add(scene, lamp):
    draw = scene.draw
    scene.size = [draw.number(0.8, 1.5, 2) for _ in range(3)]
    mesh = {"max_volume": round(math.prod(scene.size) / CELLS, 6),
            "box": [{"region": "air", "min": [0, 0, 0], "max": scene.size}]}
    scene.case["mesh"] = mesh
    for side in SIDES:
        scene.surfaces[side] = "side"
    floor = _layer(scene, mesh) if draw.chance(0.15) and not scene.radiosity else 0
    scene.slots = draw.shuffled(_eighths(scene.size, floor))
    if draw.chance(0.2):
        _add_annex(scene, mesh)
    kinds = draw.shuffled(KINDS)[:draw.integer(0, 3)]
    if scene.radiosity:
        kinds = [kind for kind in kinds if kind not in ("block", "ball", "rod")]
    if lamp == "glowing body":
        kinds = [draw.one_of(("block", "ball", "rod"))] + [kind for kind in kinds if kind not in ("block", "ball", "rod")]
    for kind in kinds:
        scene.features.add(kind)
        _add_body(scene, mesh, kind, floor)


def _layer(scene, mesh):
    """A region over the whole floor; returns its height."""
    height = round(scene.draw.number(0.2, 0.4) * scene.size[2], 3)
    mesh["box"].append({"region": "layer", "min": [0, 0, 0], "max": [scene.size[0], scene.size[1], height]})
    scene.regions["layer"] = height
    scene.features.add("layer")
    return height


def _add_annex(scene, mesh):
    """A second box of air at xmax, so that the domain is not convex."""
    draw, (a, b, c) = scene.draw, scene.size
    depth = draw.number(0.25, 0.5, 2)
    mesh["box"].append({"region": "air", "min": [a, round(0.15 * b, 4), round(0.52 * c, 4)],
                        "max": [round(a + depth, 4), round(0.8 * b, 4), round(0.9 * c, 4)],
                        "walls": dict.fromkeys(("xmax", "ymin", "ymax", "zmin", "zmax"), "annex")})
    scene.surfaces["annex"] = "plane"
    scene.features.add("annex")


def _eighths(size, floor):
    found = []
    for corner in itertools.product((0, 1), repeat=3):
        low = [k * extent / 2 for k, extent in zip(corner, size)]
        high = [(k + 1) * extent / 2 for k, extent in zip(corner, size)]
        low[2], high[2] = (floor + (size[2] - floor) * z / size[2] for z in (low[2], high[2]))
        found.append(Slot(low, high))
    return found


def _add_body(scene, mesh, kind, floor):
    draw = scene.draw
    slot = _take_slot(scene, kind, floor)
    low, high = slot.box(draw)
    middle = [round((a + b) / 2, 4) for a, b in zip(low, high)]
    radius = round(min(b - a for a, b in zip(low, high)) / 2, 3)
    if kind in ("block", "ball", "rod"):
        scene.regions[kind] = 2 * radius
        scene.body_volumes[kind] = (2 * radius) ** 3 / BODY_CELLS[kind]
        scene.occupied.append(slot)
    if kind == "block":
        mesh["box"].append({"region": "block", "min": low, "max": high})
    elif kind in ("ball", "stone"):
        _add(mesh, "sphere", scene, kind, {"center": middle, "radius": radius, "facets": 80})
    elif kind in ("rod", "pillar"):
        start, end = list(middle), list(middle)
        axis = draw.integer(0, 2)
        start[axis], end[axis] = low[axis], high[axis]
        across = round(min(b - a for k, (a, b) in enumerate(zip(low, high)) if k != axis) / 2, 3)
        _add(mesh, "cylinder", scene, kind, {"from": start, "to": end, "radius": across, "facets": draw.integer(5, 10)})
    elif kind in ("crate", "chest"):
        low[2] = 0 if kind == "chest" else low[2]
        mesh["box"].append({"hole": True, "name": kind, "min": low, "max": high})
        for side in SIDES if kind == "crate" else [side for side in SIDES if side != "zmin"]:
            scene.surfaces[f"{kind}.{side}"] = "plane"
    else:
        _add_sheet(scene, mesh, kind, low, high)


def _take_slot(scene, kind, floor):
    """A free slot; of a chest, which is on the floor, a low one."""
    fitting = [slot for slot in scene.slots if slot.low[2] <= floor] if kind == "chest" else scene.slots
    slot = (fitting or scene.slots)[0]
    scene.slots.remove(slot)
    return slot


def _add(mesh, shape, scene, kind, entry):
    """A round body: the region `kind`, or a hole whose surface is the wall `kind`."""
    if kind in scene.regions:
        entry = {"region": kind} | entry
    else:
        entry = {"hole": True, "name": kind} | entry
        scene.surfaces[kind] = "curved"
    mesh.setdefault(shape, []).append(entry)


def _add_sheet(scene, mesh, kind, low, high):
    """A rectangle across an axis, or one that leans."""
    name = "board" if kind == "sheet" else "screen"
    if kind == "sheet":
        axis = scene.draw.integer(0, 2)
        low[axis] = high[axis] = round((low[axis] + high[axis]) / 2, 4)
        entry = {"min": low, "max": high}
    else:
        (x, y, z), (X, Y, Z) = low, high
        entry = {"corners": [[x, y, z], [X, y, z], [X, Y, Z], [x, Y, Z]]}
    mesh.setdefault("sheet", []).append(entry | {"front": f"{name}.front", "back": f"{name}.back"})
    scene.surfaces[f"{name}.front"] = scene.surfaces[f"{name}.back"] = "sheet"
