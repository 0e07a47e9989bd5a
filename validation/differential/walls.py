# SPDX-License-Identifier: AGPL-3.0-or-later
"""What the walls of a scene do with light."""

# Kinds and how often they are drawn, by the shape of the wall.
WEIGHTS = {
    "side": {"black": 3, "diffuse": 4, "mirror": 2, "mixed": 1, "glossy": 1.5, "glowing": 0.7, "formula": 0.5,
             "refracting": 1},
    "plane": {"black": 2, "diffuse": 3, "glossy": 1, "glowing": 0.3},
    "curved": {"black": 2, "diffuse": 3, "glowing": 0.5},
    "sheet": {"black": 2, "diffuse": 3, "glossy": 1, "translucent": 2},
}


def add(scene, lamp):
    draw = scene.draw
    found = scene.case["walls"] = {}
    sides = [name for name, shape in scene.surfaces.items() if shape == "side"]
    scene.open_side = "zmax" if lamp.startswith("sky") else draw.one_of(sides)
    found[scene.open_side] = {}
    for name, shape in scene.surfaces.items():
        if name in found or shape == "sheet" and name.endswith("back"):
            continue
        kind = _allowed(scene, _draw_kind(draw, shape), name, lamp)
        scene.features.add(f"wall: {kind}")
        found[name] = wall(scene, kind, name)
        if shape == "sheet":
            _add_back(scene, name, found)
    found["*"] = {"diffuse": scene.per_band(lambda: draw.number(0.1, 0.7))}


def _draw_kind(draw, shape):
    weights = WEIGHTS[shape]
    at = draw.number(0, sum(weights.values()), 6)
    for kind, weight in weights.items():
        at -= weight
        if at <= 0:
            return kind
    return kind


# Lamps that are left to the directions, as is needed beside walls that refract.
SWEPT = ("lit patch", "formula wall", "glowing air")


def _allowed(scene, kind, name, lamp):
    """`kind`, or diffuse where the program refuses it: parallel mirrors, which show a lamp infinitely often, and light
    along rays beside walls that refract."""
    if kind == "refracting" and lamp not in SWEPT:
        return "diffuse"
    opposite = name.replace("min", "max") if name.endswith("min") else name.replace("max", "min")
    beside = scene.case["walls"].get(opposite, {})
    if kind in ("mirror", "mixed", "refracting") and beside.keys() & {"specular", "refractive_index"}:
        return "diffuse"
    return "diffuse" if scene.radiosity and kind in ("refracting", "formula") else kind


def wall(scene, kind, name):
    draw = scene.draw
    if kind == "diffuse":
        return {"diffuse": scene.per_band(lambda: draw.number(0.1, 0.8))}
    if kind == "mirror":
        return {"specular": scene.per_band(lambda: draw.number(0.4, 1))}
    if kind == "mixed":
        return {"specular": draw.number(0.1, 0.5), "diffuse": scene.per_band(lambda: draw.number(0.1, 0.5))}
    if kind == "glossy":
        return {"diffuse": draw.number(0, 0.15), "glossy": _glossy(scene)}
    if kind == "glowing":
        return {"diffuse": draw.number(0, 0.5), "radiance": scene.per_band(lambda: draw.number(0.1, 1))}
    if kind == "formula":
        return {"radiance": radiance_formula(scene)}
    if kind == "refracting":
        return {"refractive_index": draw.number(1.05, 1.6)}
    return {}


def radiance_formula(scene):
    """Radiance that depends on the place, and now and then on the direction."""
    draw = scene.draw
    place = f"{draw.number(0.2, 1):g} * (1 + 0.6 * sin({draw.number(1, 5):g} * x + y + 2 * z))"
    return f"{place} * (1 + 0.5 * w{draw.one_of('xyz')})" if draw.chance(0.4) else place


def _glossy(scene):
    draw = scene.draw
    model = draw.one_of(("phong", "ggx", "ward"))
    found = {"model": model, "reflectance": scene.per_band(lambda: draw.number(0.2, 0.75))}
    return found | ({"exponent": draw.number(1, 12)} if model == "phong" else {"roughness": draw.number(0.3, 0.9)})


def _add_back(scene, front, walls):
    """The back of a sheet; light goes through one that is translucent, the same share from both sides."""
    draw = scene.draw
    back = front.replace("front", "back")
    walls[back] = {"diffuse": scene.per_band(lambda: draw.number(0, 0.5))}
    if "wall: translucent" in scene.features and not walls[front]:
        share = scene.per_band(lambda: draw.number(0.1, 0.45))
        walls[front] = {"diffuse": draw.number(0, 0.4), "transmittance": share}
        walls[back]["transmittance"] = share
