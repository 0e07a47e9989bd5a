# SPDX-License-Identifier: AGPL-3.0-or-later
"""A random geometry: seed N always gives the same case file and the same files beside it."""

import dataclasses

from differential.case_text import case_text
from differential.draw import Draw

SNAP = 1e-9  # the default of mesh.snap


@dataclasses.dataclass
class Scene:
    seed: int
    kind: str
    draw: Draw
    mesh: dict = dataclasses.field(default_factory=dict)      # the table [mesh]
    bodies: list = dataclasses.field(default_factory=list)    # (name of a table in [mesh], entry), in their order
    files: dict = dataclasses.field(default_factory=dict)     # beside the case, text by name
    size: float = 1.0                                         # longest side
    known: list = dataclasses.field(default_factory=lambda: [[], [], []])  # [axis] coordinates so far
    volumes: object = None                                    # a function that returns them by region; None: unknown

    @property
    def text(self):
        """Tables of a kind may come between those of another one, since later bodies take precedence."""
        texts = [case_text({"title": f"Random geometry {self.seed}: {self.kind}", "mesh": self.mesh}),
                 *(case_text({"mesh": {shape: [entry]}}).removeprefix("[mesh]\n\n") for shape, entry in self.bodies),
                 case_text({"media": {"*": {"absorption": 1}}, "walls": {"*": {}}})]
        return "\n".join(texts)

    def gap(self):
        """None at all, or 1e-12 to 1e-3 of the size, to either side."""
        if self.draw.chance(0.4):
            return 0.0
        return self.draw.one_of((-1, 1)) * self.size * 10.0 ** self.draw.integer(-12, -3)

    def coordinate(self, axis, low, high):
        """One between two others, or an earlier one but for a gap."""
        known = self.known[axis]
        fresh = not known or self.draw.chance(0.5)
        value = self.draw.number(low, high, 9) if fresh else self.draw.one_of(known) + self.gap()
        known.append(value)
        return value
