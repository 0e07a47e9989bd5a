# SPDX-License-Identifier: AGPL-3.0-or-later
"""The lamps of a scene."""

import math

from differential.walls import radiance_formula

KINDS = ("point", "spot", "sun", "disc", "rectangle", "wall", "sky", "sky by a table", "beam", "glowing body", "lit patch",
         "formula wall", "glowing air", "patch and point")
# Lamps that histories of photons back from a probe never meet: there the field of the cell would be compared.
FORWARD_ONLY = ("point", "spot", "sun", "disc", "rectangle", "sky by a table", "beam", "patch and point")


def add(scene, kind):
    scene.backward = kind not in FORWARD_ONLY
    draw, lights = scene.draw, []
    if kind in ("point", "patch and point"):
        lights.append({"kind": "point", "position": _position(scene), "power": _power(scene)})
    if kind == "spot":
        lights.append({"kind": kind, "position": _position(scene), "direction": draw.direction(), "angle": draw.number(20, 70),
                       "falloff": draw.number(0, 10), "power": _power(scene)})
    if kind == "sun":
        lights.append({"kind": kind, "direction": _inward(scene), "irradiance": _power(scene), "walls": [scene.open_side]})
    if kind in ("disc", "rectangle"):
        lights.append(_flat_lamp(scene, kind))
    if kind in ("wall", "lit patch", "patch and point"):
        _add_patch(scene, kind, lights)
    if kind.startswith("sky"):
        lights.append(_sky(scene, kind))
    if kind == "beam":
        scene.case["walls"][scene.open_side]["beam"] = {"direction": _inward(scene), "irradiance": _power(scene)}
    if kind == "formula wall":
        scene.case["walls"][scene.open_side]["radiance"] = radiance_formula(scene)
    if kind in ("glowing body", "glowing air"):
        _add_emission(scene, kind)
    if lights:
        scene.case["light"] = [{"name": f"lamp {k}"} | light for k, light in enumerate(lights)]


def _position(scene):
    """In a slot of its own, so that no body is near."""
    return scene.slots.pop(0).inside(scene.draw)


def _power(scene):
    return scene.per_band(lambda: scene.draw.number(0.3, 2))


def _inward(scene):
    """A direction that enters by the open side, at most about 60 degrees off its normal."""
    axis = "xyz".index(scene.open_side[0])
    found = [scene.draw.number(-1, 1, 2) for _ in range(3)]
    found[axis] = 1 if scene.open_side.endswith("min") else -1
    return found


def _flat_lamp(scene, kind):
    draw = scene.draw
    slot = scene.slots.pop(0)
    room = min(b - a for a, b in zip(slot.low, slot.high))
    found = {"kind": kind, "position": slot.inside(draw, 0.1), "direction": draw.direction(), "radiance": _power(scene)}
    if kind == "disc":
        return found | {"radius": round(draw.number(0.1, 0.3) * room, 3)}
    along = draw.direction()
    return found | {"along": along, "size": [round(draw.number(0.2, 0.5) * room, 3) for _ in range(2)]}


def _add_patch(scene, kind, lights):
    """A rectangle on a side that shines, by its radiance or by a light of the kind wall."""
    draw = scene.draw
    side = draw.one_of([side for side in ("xmin", "ymin", "ymax", "zmax") if side != scene.open_side])
    low, high = [], []
    for extent in scene.size:
        start, width = draw.number(0.52, 0.6), draw.number(0.15, 0.35)
        low.append(round(start * extent, 4))
        high.append(round((start + width) * extent, 4))
    axis = "xyz".index(side[0])
    low[axis] = high[axis] = 0 if side.endswith("min") else scene.size[axis]
    scene.case["mesh"]["patch"] = [{"wall": "lamp", "min": low, "max": high}]
    found = scene.case["walls"]["lamp"] = {"diffuse": draw.number(0, 0.5)}
    if kind == "wall":
        lights.append({"kind": "wall", "walls": ["lamp"], "radiance": _power(scene)})
        return
    found["radiance"] = _power(scene)
    if kind == "lit patch" and "wall: refracting" in scene.features:
        found["uncollided"] = False
    elif kind == "lit patch" and draw.chance(0.5):
        found["uncollided"] = draw.chance(0.5)


def _sky(scene, kind):
    draw = scene.draw
    found = {"kind": "sky", "walls": ["zmax"], "radiance": _power(scene)}
    if kind == "sky":
        return found
    zenith = draw.number(1, 3)
    rows = [(angle, 1 + (zenith - 1) * math.cos(math.radians(angle))) for angle in range(0, 91, 15)]
    scene.files["sky.csv"] = "".join(f"{angle}, {value:.4f}\n" for angle, value in rows)
    return found | {"distribution": "sky.csv", "direction": [0, 0, -1]}


def _add_emission(scene, kind):
    """Emission of the air, or of a body by rays or by the sweep."""
    draw, media = scene.draw, scene.case["media"]
    name = "air" if kind == "glowing air" else next(name for name in scene.regions if name in ("block", "ball", "rod"))
    if kind == "glowing body":
        media[name]["uncollided"] = draw.chance(0.5)
    if draw.chance(0.3):
        media[name]["emission"] = f"{draw.number(0.3, 2):g} * (1 + 0.5 * sin(3 * x - 2 * z))"
    else:
        media[name][draw.one_of(("emission", "power_density", "power"))] = _power(scene)
