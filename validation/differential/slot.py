# SPDX-License-Identifier: AGPL-3.0-or-later
"""The parts of a room that hold one body or lamp each."""

import dataclasses


@dataclasses.dataclass
class Slot:
    """An eighth of the room, or of what is above a layer, in which one body or lamp is."""

    low: list
    high: list

    def inside(self, draw, share=0.3):
        """A point near the middle; `share` of each extent is where it may be."""
        return [round(draw.number((a + b - share * (b - a)) / 2, (a + b + share * (b - a)) / 2, 6), 4)
                for a, b in zip(self.low, self.high)]

    def box(self, draw, margin=0.12):
        """Corners of a box that leaves a margin to the neighbouring slots."""
        low, high = [], []
        for a, b in zip(self.low, self.high):
            low.append(round(draw.number(a + margin * (b - a), a + 2 * margin * (b - a), 6), 4))
            high.append(round(draw.number(b - 2 * margin * (b - a), b - margin * (b - a), 6), 4))
        return low, high
