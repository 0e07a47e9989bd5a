# SPDX-License-Identifier: AGPL-3.0-or-later
"""The case of a scene that a motion has moved. Radiances stay, so coefficients are divided by the factor of scale s, emissions
and densities of leaves too, and powers are multiplied by s^2."""

import copy

# By the power of the factor of scale; values are numbers, formulas or lists of them.
PER_LENGTH = ("absorption", "scattering", "extinction", "emission", "power_density", "kernel", "area_density", "density")
LENGTHS = ("radius", "size")
PLACES, DIRECTIONS = ("position",), ("direction", "along", "normal", "axis")


def moved_case(case, motion):
    found = copy.deepcopy(case)
    for name, medium in found["media"].items():
        found["media"][name] = _moved_medium(medium, motion)
    for wall in found["walls"].values():
        if "radiance" in wall:
            wall["radiance"] = _each(wall["radiance"], motion, 1)
        if "beam" in wall:
            wall["beam"]["direction"] = motion.direction(wall["beam"]["direction"])
    for light in found.get("light", []):
        _move_light(light, motion)
    for probe in found.get("probe", []):
        probe["points"] = [motion.place(point) for point in probe["points"]]
        if "normal" in probe:
            probe["normal"] = motion.direction(probe["normal"])
    if motion.rotation:
        found["directions"]["rotation"] = motion.rotation
    return found


def _moved_medium(medium, motion):
    found = {}
    for key, value in medium.items():
        if key in PER_LENGTH:
            found[key] = _each(value, motion, 1 / motion.scale)
        elif key == "power":
            found[key] = _each(value, motion, motion.scale ** 2)
        elif key in ("leaves", "flakes"):
            found[key] = _moved_medium(value, motion)
        else:
            found[key] = motion.direction(value) if key == "axis" else value
    return found


def _move_light(light, motion):
    for key, value in light.items():
        if key in PLACES:
            light[key] = motion.place(value)
        elif key in DIRECTIONS:
            light[key] = motion.direction(value)
        elif key in LENGTHS:
            light[key] = _each(value, motion, motion.scale)
        elif key == "power":
            light[key] = _each(value, motion, motion.scale ** 2)


def _each(value, motion, factor):
    if isinstance(value, list):
        return [_each(entry, motion, factor) for entry in value]
    if isinstance(value, str):
        return f"{factor!r} * ({motion.formula(value)})"
    return factor * value
