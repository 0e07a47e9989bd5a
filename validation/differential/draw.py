# SPDX-License-Identifier: AGPL-3.0-or-later
"""Random numbers of a scene. All are made from random(), the one generator whose sequence Python guarantees."""

import math
import random


def rounded(value, digits=4):
    """`value` with so many significant digits: short in a case file, and the same on every machine."""
    return float(f"{value:.{digits}g}")


class Draw:
    def __init__(self, seed):
        self._random = random.Random(seed).random

    def chance(self, probability):
        return self._random() < probability

    def number(self, low, high, digits=3):
        return rounded(low + (high - low) * self._random(), digits)

    def logarithmic(self, low, high, digits=3):
        """A number whose logarithm is uniform."""
        return rounded(math.exp(math.log(low) + (math.log(high) - math.log(low)) * self._random()), digits)

    def integer(self, low, high):
        """From `low` to `high`, both included."""
        return low + int((high - low + 1) * self._random())

    def one_of(self, values):
        return values[self.integer(0, len(values) - 1)]

    def shuffled(self, values):
        found = list(values)
        for i in range(len(found) - 1, 0, -1):
            j = self.integer(0, i)
            found[i], found[j] = found[j], found[i]
        return found

    def direction(self, low=-1.0, high=1.0):
        """A vector of about unit length whose z component, before rounding, is uniform in [low, high]."""
        z = low + (high - low) * self._random()
        azimuth = 2 * math.pi * self._random()
        across = math.sqrt(max(0.0, 1 - z * z))
        return [rounded(across * math.cos(azimuth), 3), rounded(across * math.sin(azimuth), 3), rounded(z, 3)]
