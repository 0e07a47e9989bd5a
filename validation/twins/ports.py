# SPDX-License-Identifier: AGPL-3.0-or-later
"""Regions and walls between which light goes both ways: each can shine alone, and receive."""

import copy

from suite.result import read_rows

from twins import shared_light

SIDE = 0.5  # of the boxes, as a part of the slot that each is in


def with_boxes(scene):
    """The case with a box of the air's medium in each of two free slots, and the names of these regions."""
    case = shared_light.only(scene.case, ())
    names = []
    for slot in scene.slots[:2]:
        low, high = ([round(a + part * (b - a), 4) for a, b in zip(slot.low, slot.high)] for part in (SIDE / 2, 1 - SIDE / 2))
        names.append(f"port {len(names)}")
        case["mesh"]["box"].append({"region": names[-1], "min": low, "max": high})
        case["media"][names[-1]] = copy.deepcopy(case["media"]["air"])
    return case, names


def candidates(case, regions):
    """All (table, name) that can be ports. Walls that refract shine by what is behind them; and a mirror has nothing to absorb."""
    walls = [name for name, wall in case["walls"].items() if name != "*" and not {"refractive_index", "specular"} & wall.keys()]
    return [("media", name) for name in regions] + [("walls", name) for name in walls]


def shining(case, port):
    """The case in which the port alone shines: emission 1 in a region, radiance 1 of a wall."""
    found = copy.deepcopy(case)
    table, name = port
    found[table][name] |= {"emission" if table == "media" else "radiance": 1.0, "uncollided": False}
    return found


def received(result, port):
    """Value and standard error, by band, of the light that comes to a port: the integral of the fluence, or the power."""
    table, name = port
    file, key, quantity = (("regions.csv", "region", "fluence_mean"), ("walls.csv", "wall", "incoming"))[table == "walls"]
    found = {}
    for row in read_rows(result.folder / file):
        if row[key] == name:
            extent = float(row["volume"]) if table == "media" else 1.0
            found[row["band"]] = (extent * float(row[quantity]), extent * float(row.get(f"{quantity}_error") or 0))
    return found
