# SPDX-License-Identifier: AGPL-3.0-or-later
"""Power that arrives at each wall from a rectangular lamp in the ceiling, partly hidden by a sheet parallel to it.

From a point below the sheet the sheet hides a rectangle of the lamp's plane. The irradiance is that of the lamp less that of
the hidden rectangle, each by Lambert's formula for polygons (Modest, Radiative Heat Transfer, configuration 10 and 11)."""

import numpy

from suite.row import Row

ROOM = (1.0, 0.8, 0.6)
LAMP = (0.2, 0.7, 0.2, 0.6)  # xmin, xmax, ymin, ymax
SHEET, SHEET_Z = (0.3, 0.65, 0.2, 0.5), 0.25
PANELS, NODES = 120, 3


def irradiance(rectangle, height, points, normal):
    """Of a rectangle xmin, xmax, ymin, ymax of radiance 1 in the plane z = height, 0 where it is empty; [point]"""
    x0, x1, y0, y1 = rectangle
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    ray = [numpy.stack([x - points[0], y - points[1], height - points[2]]) for x, y in corners]
    ray = [r / numpy.sqrt((r**2).sum(axis=0)) for r in ray]
    total = 0.0
    for one, next_one in zip(ray, ray[1:] + ray[:1]):
        across = numpy.cross(one, next_one, axis=0)
        length = numpy.sqrt((across**2).sum(axis=0))
        angle = numpy.arctan2(length, (one * next_one).sum(axis=0))
        total = total + angle * numpy.tensordot(normal, across, axes=1) / numpy.maximum(length, 1e-300)
    return 0.5 * numpy.abs(total) * ((x1 > x0) & (y1 > y0))


def hidden(points):
    """The part of the lamp that the sheet hides: xmin, xmax, ymin, ymax, each [point]; empty above the sheet."""
    below = points[2] < SHEET_Z
    stretch = (ROOM[2] - points[2]) / numpy.where(below, SHEET_Z - points[2], 1.0)
    shadow = [points[axis // 2] + (SHEET[axis] - points[axis // 2]) * stretch for axis in range(4)]
    x0, x1 = numpy.clip(shadow[0], *LAMP[:2]), numpy.clip(shadow[1], *LAMP[:2])
    y0, y1 = numpy.clip(shadow[2], *LAMP[2:]), numpy.clip(shadow[3], *LAMP[2:])
    return x0, numpy.where(below, x1, x0), y0, y1


def power(origin, first, second, normal, behind_sheet=True):
    """That arrives at the parallelogram origin + s first + t second [W]."""
    nodes, weights = numpy.polynomial.legendre.leggauss(NODES)
    places = ((numpy.arange(PANELS)[:, None] + 0.5 + 0.5 * nodes) / PANELS).ravel()
    weights = numpy.tile(0.5 * weights / PANELS, PANELS)
    s, t = (grid.ravel() for grid in numpy.meshgrid(places, places, indexing="ij"))
    origin, first, second, normal = (numpy.asarray(vector, dtype=float) for vector in (origin, first, second, normal))
    points = origin[:, None] + first[:, None] * s + second[:, None] * t
    arriving = irradiance(LAMP, ROOM[2], points, normal)
    if behind_sheet:
        arriving = arriving - irradiance(hidden(points), ROOM[2], points, normal)
    area = numpy.linalg.norm(numpy.cross(first, second))
    return float(area * numpy.outer(weights, weights).ravel() @ arriving)


def exact():
    x, y, z = ROOM
    x0, x1, y0, y1 = SHEET
    return {
        "xmin": power([0, 0, 0], [0, y, 0], [0, 0, z], [1, 0, 0]),
        "xmax": power([x, 0, 0], [0, y, 0], [0, 0, z], [-1, 0, 0]),
        "ymin": power([0, 0, 0], [x, 0, 0], [0, 0, z], [0, 1, 0]),
        "ymax": power([0, y, 0], [x, 0, 0], [0, 0, z], [0, -1, 0]),
        "zmin": power([0, 0, 0], [x, 0, 0], [0, y, 0], [0, 0, 1]),
        "sheet_top": power([x0, y0, SHEET_Z], [x1 - x0, 0, 0], [0, y1 - y0, 0], [0, 0, 1], behind_sheet=False),
        "sheet_bottom": 0.0,
    }


def compare(runs):
    known = exact()
    lamp = numpy.pi * (LAMP[1] - LAMP[0]) * (LAMP[3] - LAMP[2])
    found = [Row("all walls / lamp, exact", sum(known.values()) / lamp, 1.0)]
    for name, result in runs.items():
        for wall, value in known.items():
            found.append(Row(f"{name}: {wall} / lamp", result.wall(wall, "incoming") / lamp, value / lamp))
        found.append(Row(f"{name}: all walls / lamp", sum(result.wall(wall, "incoming") for wall in known) / lamp, 1.0))
    return found
