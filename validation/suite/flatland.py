# SPDX-License-Identifier: AGPL-3.0-or-later
"""Exact light of cases/flatland-room: a lamp in the plane, an absorbing gas and a pillar. At a point the lamp is seen in
an interval of angles, of which the pillar, wherever it is in the way, takes another; what is left are integrals of
cos t exp(-absorption distance)."""

import math

import numpy

LAMP = ((0.6, 1.0), (1.0, 1.0))
PILLAR = ((1.1, 0.4), (1.3, 0.4), (1.3, 0.6), (1.1, 0.6))
# From, to and the normal that points out of the room.
WALLS = {
    "xmin": ((0.0, 0.0), (0.0, 1.0), (-1, 0)),
    "xmax": ((2.0, 0.0), (2.0, 1.0), (1, 0)),
    "ymin": ((0.0, 0.0), (2.0, 0.0), (0, -1)),
    "pillar.xmin": ((1.1, 0.4), (1.1, 0.6), (1, 0)),
    "pillar.ymax": ((1.1, 0.6), (1.3, 0.6), (0, -1)),
}
GAUSS = numpy.polynomial.legendre.leggauss(24)


class Lamp:
    def __init__(self, absorption):
        self.absorption = absorption

    def fluence(self, place):
        return self._integral(place, lambda x, y: 1.0)

    def irradiance(self, place, outward):
        """On a wall whose normal out of the room is `outward`."""
        return self._integral(place, lambda x, y: numpy.maximum(0, -(x * outward[0] + y * outward[1])))

    def mean_irradiance(self, start, end, outward, points=2000):
        start, end = numpy.array(start), numpy.array(end)
        places = start + (end - start) * ((numpy.arange(points) + 0.5) / points)[:, None]
        return float(numpy.mean([self.irradiance(tuple(place), outward) for place in places]))

    def _integral(self, place, factor):
        """Over the angles at which the lamp is seen from `place`; `factor` is one of the direction towards it."""
        total = 0.0
        height = LAMP[0][1] - place[1]
        for low, high in visible(place):
            angles = 0.5 * (low + high) + 0.5 * (high - low) * GAUSS[0]
            x, y = numpy.cos(angles), numpy.sin(angles)
            values = factor(x, y) * numpy.exp(-self.absorption * height / y)
            total += 0.5 * (high - low) * float(numpy.sum(GAUSS[1] * values))
        return total


def visible(place):
    """Intervals of angles, counted from x, in which the lamp is seen. All lies below the lamp's wall."""
    if place[1] >= LAMP[0][1]:
        return []
    low, high = sorted(angle(place, end) for end in LAMP)
    hidden = [angle(place, corner) for corner in PILLAR]
    # Seen from the left the pillar lies around the angle 0, from the right around pi.
    if max(hidden) - min(hidden) > math.pi:
        hidden = [a % (2 * math.pi) for a in hidden]
    if on_pillar(place):
        return [(low, high)]
    first, last = min(hidden), max(hidden)
    parts = [(low, min(high, first)), (max(low, last), high)]
    return [(a, b) for a, b in parts if b > a]


def on_pillar(place):
    """On its sides that see the lamp: what they hide lies behind them."""
    left, right, top = PILLAR[0][0], PILLAR[1][0], PILLAR[2][1]
    return (place[0] == left and PILLAR[0][1] <= place[1] <= top) or (place[1] == top and left <= place[0] <= right)


def angle(place, target):
    return math.atan2(target[1] - place[1], target[0] - place[0])
