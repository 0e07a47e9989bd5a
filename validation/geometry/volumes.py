# SPDX-License-Identifier: AGPL-3.0-or-later
"""Volumes of parts of space that convex bodies cut out, by lines that cross them at random places."""

import collections
import dataclasses

import numpy

REPLICAS = 8    # independent sets of lines, whose spread shows the error
STRATA = 24     # lines of a set: so many squared, one in each square of the body's shadow


@dataclasses.dataclass
class Volume:
    value: float = 0.0
    variance: float = 0.0
    area: float = 0.0  # at most, of its surface: times the distance of a move, the change of the volume


def exact_boxes(boxes, label_of):
    """Volumes by label of boxes (low, high), cut along all their planes; label_of(numbers of boxes around a point)."""
    cuts = [numpy.unique([corner[axis] for box in boxes for corner in box]) for axis in range(3)]
    middles = numpy.meshgrid(*((cut[1:] + cut[:-1]) / 2 for cut in cuts), indexing="ij")
    sizes = numpy.einsum("i,j,k->ijk", *(numpy.diff(cut) for cut in cuts))
    inside = [numpy.all([(low[a] < middles[a]) & (middles[a] < high[a]) for a in range(3)], axis=0)
              for low, high in boxes]
    found = collections.defaultdict(Volume)
    masks = _masks(inside)
    for mask in numpy.unique(masks):
        label = label_of(_members(mask))
        if label is not None:
            found[label].value += float(sizes[masks == mask].sum())
    for number, (low, high) in enumerate(boxes):
        if label_of([number]) in found:
            found[label_of([number])].area += len(boxes) * _area(numpy.subtract(high, low))
    return dict(found)


def by_lines(bodies, owner_of, label_of, seed):
    """Volumes by label. A point belongs to one body among those around it, owner_of(their numbers); it is counted by
    the lines through the box around that body, so that small bodies are seen as well as large ones."""
    generator = numpy.random.default_rng(seed)
    found = collections.defaultdict(Volume)
    planes = [body.planes() for body in bodies]
    for number, body in enumerate(bodies):
        sets = [_by_set(body, planes, generator, replica % 3) for replica in range(REPLICAS)]
        sums = collections.defaultdict(lambda: [0.0] * REPLICAS)
        for replica, lengths in enumerate(sets):
            for mask, volume in lengths.items():
                around = _members(mask)
                if around and owner_of(around) == number and label_of(around) is not None:
                    sums[label_of(around)][replica] += volume
        for label, values in sums.items():
            found[label].value += float(numpy.mean(values))
            found[label].variance += float(numpy.var(values, ddof=1)) / REPLICAS
            found[label].area += len(bodies) * _area(body.high - body.low)
    return dict(found)


def _by_set(body, planes, generator, axis):
    """Volumes by the set of bodies around, a mask of bits, of lines along an axis through the box around a body."""
    low, extent = body.low, body.high - body.low
    others = [k for k in range(3) if k != axis]
    strata = numpy.stack(numpy.meshgrid(numpy.arange(STRATA), numpy.arange(STRATA)), axis=-1).reshape(-1, 2)
    origins = numpy.tile(low, (len(strata), 1))
    origins[:, others] += (strata + generator.random(strata.shape)) / STRATA * extent[others]
    spans = [_span(origins, axis, *pair) for pair in planes]
    ends = [numpy.zeros(len(origins)), numpy.full(len(origins), extent[axis])]
    cuts = numpy.sort(numpy.clip(numpy.stack([*ends, *(end for span in spans for end in span)], axis=1),
                                 0, extent[axis]), axis=1)
    middles, lengths = (cuts[:, 1:] + cuts[:, :-1]) / 2, numpy.diff(cuts, axis=1)
    masks = _masks([(start[:, None] < middles) & (middles < end[:, None]) for start, end in spans])
    shadow = extent[others].prod() / len(origins)
    return {int(mask): float(lengths[masks == mask].sum() * shadow) for mask in numpy.unique(masks)}


def _span(origins, axis, normals, offsets):
    """Where lines along an axis enter and leave a convex body; an empty span where they miss it."""
    slopes, gaps = normals[:, axis], offsets - origins @ normals.T
    flat = numpy.abs(slopes) < 1e-13
    with numpy.errstate(divide="ignore", invalid="ignore"):
        at = gaps / slopes
    start = numpy.where(slopes < 0, at, -numpy.inf)[:, ~flat].max(axis=1)
    end = numpy.where(slopes > 0, at, numpy.inf)[:, ~flat].min(axis=1)
    misses = (gaps[:, flat] < 0).any(axis=1) | (start >= end)
    return numpy.where(misses, 0, start), numpy.where(misses, 0, end)


def _masks(inside):
    return sum(is_in.astype(numpy.int64) << number for number, is_in in enumerate(inside))


def _members(mask):
    return [number for number in range(int(mask).bit_length()) if int(mask) >> number & 1]


def _area(extent):
    """Of a box; no convex body in it has a larger surface."""
    a, b, c = map(float, extent)
    return 2 * (a * b + b * c + c * a)
