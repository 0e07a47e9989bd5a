# SPDX-License-Identifier: AGPL-3.0-or-later
"""A random scene: seed N always gives the same case file."""

import dataclasses

from differential import bodies, lamps, media, walls
from differential.case_text import case_text
from differential.draw import Draw

BANDS = (["grey"], ["red", "blue"], ["red", "green", "blue"])
PROBE_POINTS = 4


@dataclasses.dataclass
class Scene:
    seed: int
    draw: Draw
    case: dict = dataclasses.field(default_factory=dict)
    files: dict = dataclasses.field(default_factory=dict)     # tables beside the case, text by name
    features: set = dataclasses.field(default_factory=set)    # words for what the scene has
    slots: list = dataclasses.field(default_factory=list)     # free ones
    occupied: list = dataclasses.field(default_factory=list)  # those whose bodies are regions
    regions: dict = dataclasses.field(default_factory=dict)   # name: size [m], without the room itself
    body_volumes: dict = dataclasses.field(default_factory=dict)  # of fine cells, by body [m^3]
    surfaces: dict = dataclasses.field(default_factory=dict)  # wall name: "side", "plane", "curved", "sheet"
    size: list = dataclasses.field(default_factory=list)      # of the room
    open_side: str = ""                                       # a black side, by which light leaves
    backward: bool = True                                     # histories of photons back from probes meet the lamps

    @property
    def bands(self):
        return len(self.case["bands"]["names"])

    @property
    def radiosity(self):
        return "radiosity" in self.features

    @property
    def coefficients_by_place(self):
        """Whether a medium has absorption or scattering by a formula of the place, which photons read as means of cells."""
        return bool({"room: formula", "body: formula"} & self.features)

    @property
    def text(self):
        return case_text(self.case)

    def per_band(self, number):
        """`number()` for each band, now and then one for all."""
        if self.bands == 1 or self.draw.chance(0.25):
            return number()
        return [number() for _ in range(self.bands)]


def make(seed):
    scene = Scene(seed, Draw(seed))
    medium, lamp = media.KINDS[seed % len(media.KINDS)], lamps.KINDS[seed % len(lamps.KINDS)]
    if medium == "void" and seed // len(media.KINDS) % 4 != 3:
        scene.features.add("radiosity")
        lamp = "lit patch"
    scene.features |= {f"room: {medium}", f"lamp: {lamp}"}
    scene.case = {"title": f"Random scene {seed}: {medium}, {lamp}", "bands": {"names": scene.draw.one_of(BANDS)}}
    bodies.add(scene, lamp)
    media.add(scene, medium)
    walls.add(scene, lamp)
    lamps.add(scene, lamp)
    _add_numerics(scene)
    _add_probes(scene)
    return scene


def _add_numerics(scene):
    scene.case["directions"] = {"set": "ldfe-sq", "order": 2}
    scene.case["solve"] = {"tolerance": 1e-5, "max_sweeps": 300}
    if media.take_moments(scene) and scene.draw.chance(0.3):
        scene.features.add("first_collided")
        scene.case["directions"]["first_collided"] = {"order": 3}


def _add_probes(scene):
    """Points inside, and on the side opposite to the open one; none where photons would read them off their cells."""
    if not scene.backward:
        return
    draw = scene.draw
    places = draw.shuffled(scene.slots + scene.occupied)[:PROBE_POINTS]
    scene.case["probe"] = [{"name": "inside", "points": [slot.inside(draw) for slot in places]}]
    _add_wall_probe(scene)


def _add_wall_probe(scene):
    """A point of the side opposite to the open one, in front of a free slot."""
    axis, end = "xyz".index(scene.open_side[0]), 1 if scene.open_side.endswith("min") else 0
    place = scene.size[axis] * end
    facing = [slot for slot in scene.slots if place in (slot.low[axis], slot.high[axis])]
    if "annex" in scene.features and (axis, end) == (0, 1):  # the annex opens in the upper half of this side
        facing = [slot for slot in facing if slot.low[2] == 0]
    if not facing:
        return
    normal = [0, 0, 0]
    normal[axis] = -1 if end else 1
    point = facing[0].inside(scene.draw)
    point[axis] = place
    scene.case["probe"].append({"name": "wall", "points": [point], "normal": normal})
