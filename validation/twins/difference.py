# SPDX-License-Identifier: AGPL-3.0-or-later
"""Differences of two answers."""

import dataclasses
import math

import numpy


@dataclasses.dataclass
class Difference:
    """The largest difference of a quantity in a band, over what is allowed; and how many values were compared."""

    where: str
    quantity: str
    band: str
    first: float
    second: float
    allowed: float
    count: int

    @property
    def ratio(self):
        """Above 1 where the twins differ; infinite where a value is not a number."""
        if self.second == self.first:
            return 0.0
        ratio = abs(self.second - self.first) / self.allowed if self.allowed > 0 else math.inf
        return float(ratio) if math.isfinite(ratio) else math.inf

    def __str__(self):
        return (f"{self.quantity}, {self.band}, {self.where}: {self.first:.9g} and {self.second:.9g}, "
                f"{self.ratio:.3g} of what is allowed")


def by_size(expected, found, tolerance):
    """Of each quantity the largest difference, where `tolerance` of its largest value in the band is allowed."""
    return _largest(expected, found, lambda key, *_: tolerance * expected.size(key))


def by_error(expected, found, units):
    """Of each quantity the largest difference, where so many of the standard errors of both together are allowed."""
    rounding = 1e-12  # of the size of a quantity that has no noise
    return _largest(expected, found, lambda key, first, second: numpy.hypot(
        units * numpy.hypot(first, second), rounding * expected.size(key)))


def _largest(expected, found, allow):
    missing = expected.values.keys() ^ found.values.keys()
    rows = [Difference("in one answer alone", quantity, band, numpy.nan, numpy.nan, 1, 1) for quantity, band in sorted(missing)]
    for key in expected.values.keys() & found.values.keys():
        places, first, first_error = expected.values[key]
        others, second, second_error = found.values[key]
        if places.tolist() != others.tolist():
            rows.append(Difference("other places", *key, numpy.nan, numpy.nan, 1, 1))
            continue
        allowed = numpy.broadcast_to(allow(key, first_error, second_error), first.shape)
        with numpy.errstate(invalid="ignore", divide="ignore"):
            ratios = numpy.nan_to_num(abs(second - first) / allowed, nan=numpy.inf)
        ratios[second == first] = 0
        at = numpy.unravel_index(ratios.argmax(), ratios.shape)
        rows.append(Difference(str(places[at[0]]), *key, first[at], second[at], allowed[at], first.size))
    return rows
