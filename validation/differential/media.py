# SPDX-License-Identifier: AGPL-3.0-or-later
"""The media of a scene."""

import math

KINDS = ("absorbing", "isotropic", "henyey-greenstein", "rayleigh", "table", "legendre", "mixture", "formula", "directional",
         "leaves", "flakes", "kernel", "void")
SCATTERING = ("isotropic", "henyey-greenstein", "rayleigh", "table", "legendre", "mixture", "formula")
ANGLES = ("horizontal", "planophile", "plagiophile", "erectophile", "spherical", "uniform", "vertical")
# Without moments: a matrix between the directions, or nothing to scatter.
MATRIX = ("leaves", "flakes", "kernel")


def add(scene, kind):
    """`kind` in the room; other regions draw theirs."""
    draw = scene.draw
    size = math.prod(scene.size) ** (1 / 3)
    scene.case["media"] = {"air": medium(scene, kind, "air", draw.logarithmic(0.3, 8) / size)}
    for name, extent in scene.regions.items():
        inner = draw.one_of(KINDS)
        scene.features.add(f"body: {inner}")
        scene.case["media"][name] = medium(scene, inner, name, draw.logarithmic(0.2, 6) / extent)
    _choose_methods(scene)


def take_moments(scene):
    """Whether all media scatter through moments where that is left to the program: what first_collided needs."""
    return all("scattering_method" not in entry and not set(MATRIX) & entry.keys() for entry in scene.case["media"].values())


def medium(scene, kind, name, extinction):
    """The table of a medium whose extinction is about `extinction` [1/m]."""
    draw = scene.draw
    if kind == "void":
        return {}
    if kind == "absorbing":
        return {"absorption": scene.per_band(lambda: draw.number(0.5 * extinction, extinction))}
    if kind == "leaves":
        leaf = [scene.per_band(lambda: draw.number(0.05, 0.47)) for _ in range(2)]
        return {"leaves": {"area_density": round(2 * extinction, 3), "angles": draw.one_of(ANGLES), "reflectance": leaf[0],
                           "transmittance": leaf[1]}}
    if kind == "flakes":
        sizes = {"along": draw.number(0.2, 1), "across": draw.number(0.2, 1)}
        axis = draw.direction()
        albedo = scene.per_band(lambda: draw.number(0.1, 0.95))
        return {"flakes": {"density": round(extinction, 3), "axis": axis} | sizes | {"albedo": albedo}}
    if kind == "kernel":
        part = draw.number(0.2, 0.9) * extinction / (4 * math.pi)
        lean = draw.number(-0.8, 0.8, 2)
        return {"absorption": round(0.3 * extinction, 3), "reciprocal": True,
                "kernel": f"{part:.3g} * (1 + {lean:g} * (wx*vx + wy*vy + wz*vz))"}
    if kind == "directional":
        return {"absorption": f"{extinction:g} * (1 + {draw.number(-0.7, 0.7, 2):g} * w{draw.one_of('xyz')})"}
    return _scattering(scene, kind, name, extinction)


def _scattering(scene, kind, name, extinction):
    draw = scene.draw
    albedo = scene.per_band(lambda: draw.number(0.2, 0.98))
    if kind == "formula":
        found = _formulas(scene, extinction, albedo if isinstance(albedo, float) else albedo[0])
    else:
        found = {"extinction": scene.per_band(lambda: draw.number(0.6 * extinction, extinction)), "albedo": albedo}
    phase = _phase(scene, kind if kind != "formula" else draw.one_of(("isotropic", "henyey-greenstein")), name)
    if phase:
        found["phase"] = phase
    return found


def _formulas(scene, extinction, albedo):
    """Absorption and scattering that depend on the place and are nowhere negative."""
    draw = scene.draw
    axis = draw.one_of("xyz")
    shape = draw.one_of((f"exp(-1.5 * {axis})", f"(0.1 + {axis}^2)", f"(1 + 0.8 * sin(4 * {axis} + x))",
                         f"max(0, 1 - {axis})"))
    return {"absorption": f"{(1 - albedo) * extinction:.3g} * {shape}", "scattering": f"{albedo * extinction:.3g} * {shape}"}


def _phase(scene, kind, name):
    draw = scene.draw
    if kind == "henyey-greenstein":
        return {"model": kind, "g": draw.number(-0.5, 0.95, 2)}
    if kind == "rayleigh":
        return {"model": kind}
    if kind == "legendre":
        g = draw.number(-0.3, 0.6, 2)
        return {"model": kind, "coefficients": [1, g, round(0.4 * abs(g), 3), round(0.1 * g, 3)]}
    if kind == "mixture":
        return {"model": kind, "mix": [{"weight": draw.number(0.2, 0.8, 2), "model": "rayleigh"},
                                       {"weight": 0.5, "model": "henyey-greenstein", "g": draw.number(0.2, 0.8, 2)}]}
    if kind == "table":
        file = f"phase_{name}.csv"
        scene.files[file] = _phase_table(draw.number(-0.4, 0.9, 2), draw.number(0, 0.6, 2))
        return {"model": kind, "file": file}
    return {}


def _phase_table(slope, curvature):
    rows = [(k / 10 - 1, math.exp(slope * (k / 10 - 1)) + curvature * (k / 10 - 1) ** 2) for k in range(21)]
    return "".join(f"{mu:g}, {value:.5f}\n" for mu, value in rows)


def _choose_methods(scene):
    """Asks half of the scattering media for a method."""
    for entry in scene.case["media"].values():
        if "phase" in entry and scene.draw.chance(0.5):
            entry["scattering_method"] = scene.draw.one_of(("moments", "dense", "galerkin"))
