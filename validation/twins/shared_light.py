# SPDX-License-Identifier: AGPL-3.0-or-later
"""What shines in a case, divided among two cases."""

import copy

from twins.small_scene import EMISSIONS, has_rays


def emitters(case):
    """(table, name) of each."""
    found = [("media", name) for name, entry in case["media"].items() if set(EMISSIONS) & entry.keys()]
    found += [("walls", name) for name, entry in case["walls"].items() if {"radiance", "beam"} & entry.keys()]
    return found + [("light", k) for k in range(len(case.get("light", [])))]


def only(case, kept):
    """The case in which only these shine. Without light along rays nothing collides first."""
    found = copy.deepcopy(case)
    for table, name in emitters(case):
        if (table, name) not in kept and table != "light":
            for key in (*EMISSIONS, "radiance", "beam", "uncollided"):
                found[table][name].pop(key, None)
    if "light" in found:
        found["light"] = [light for k, light in enumerate(found["light"]) if ("light", k) in kept]
        if not found["light"]:
            del found["light"]
    if not has_rays(found):
        found["directions"].pop("first_collided", None)
    return found


def with_more(scene):
    """The case with at least two that shine: those of the scene, the floor or ceiling, and a point where there is room."""
    case, draw = copy.deepcopy(scene.case), scene.draw
    for side in ("zmin", "ymax"):
        wall = case["walls"].get(side)
        if wall is not None and not {"radiance", "beam", "refractive_index"} & wall.keys():
            wall |= {"radiance": draw.number(0.1, 1), "uncollided": False}
            break
    if scene.slots and not scene.refracting and draw.chance(0.4):
        lamp = {"name": "another", "kind": "point", "position": scene.slots[0].inside(draw), "power": draw.number(0.3, 2)}
        case["light"] = [*case.get("light", []), lamp]
    return case
