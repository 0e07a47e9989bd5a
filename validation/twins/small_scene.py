# SPDX-License-Identifier: AGPL-3.0-or-later
"""Random scenes of etendue-differential on few cells and directions: twins share the errors of both, so these need not be small."""

import copy
import dataclasses

from differential import scene as scenes
from differential.draw import Draw

from twins import tolerances

LARGER_CELLS = 8
# Sets that the 48 rotations and mirrors of the axes map onto themselves.
SETS = (("ldfe-sq", 1), ("thurgood", 3), ("level-symmetric", 8))
EMISSIONS = ("emission", "power_density", "power")


@dataclasses.dataclass
class SmallScene:
    seed: int
    case: dict
    files: dict
    features: set
    slots: list
    draw: Draw  # of the twins

    @property
    def upright(self):
        """Whether z has to stay the vertical: leaves are inclined to it."""
        return any("leaves" in medium for medium in self.case["media"].values())

    @property
    def refracting(self):
        return any("refractive_index" in wall for wall in self.case["walls"].values())

    @property
    def glossy(self):
        return any("glossy" in wall for wall in self.case["walls"].values())

    @property
    def along_rays(self):
        return has_rays(self.case)


def has_rays(case):
    """Whether light is followed along rays to cells and faces."""
    emitters = [*case["media"].values(), *case["walls"].values()]
    return bool(case.get("light")) or any("beam" in entry or entry.get("uncollided") for entry in emitters)


def make(seed):
    made, draw = scenes.make(seed), Draw(1_000_000 + seed)
    case = copy.deepcopy(made.case)
    case["mesh"]["max_volume"] *= LARGER_CELLS
    case["directions"] |= dict(zip(("set", "order"), draw.one_of(SETS)))
    if "first_collided" in case["directions"]:
        case["directions"]["first_collided"]["order"] = 2
    case["solve"] = {"tolerance": tolerances.SOLVE, "max_sweeps": 500, "precision": draw.one_of(("auto", "double")),
                     "threads": 1}
    case["output"] = {"fields": ["fluence", "net_flux"]}
    found = SmallScene(seed, case, made.files, made.features, made.slots, draw)
    _choose_rays(found)
    return found


def _choose_rays(scene):
    """Sets for every emission whether it is followed along rays, so that the scene knows. Mirrors repeat it too often."""
    rays = not scene.refracting and not any("specular" in wall for wall in scene.case["walls"].values()) and scene.draw.chance(0.3)
    for name, entry in scene.case["walls"].items():
        if "radiance" in entry:
            entry["uncollided"] = rays and name == "lamp"
    for name, entry in scene.case["media"].items():
        if set(EMISSIONS) & entry.keys():
            entry["uncollided"] = rays and name != "air"
