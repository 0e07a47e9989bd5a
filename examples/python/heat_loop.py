#!/usr/bin/python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Conduction and radiation in a loop: a heated block of cubes in explicit steps of conduction, with the divergence of
the radiative heat flux from etendue every few steps. Nothing is written to files.

Run it with PYTHONPATH=build/release/python /usr/bin/python3 examples/python/heat_loop.py"""

import itertools

import etendue
import numpy

CUBES = (6, 3, 3)
SIDE = 0.1  # of a cube [m]
CONDUCTIVITY = 0.5  # [W/(m K)]
HEAT_CAPACITY = 1e5  # of a volume [J/(m^3 K)]
ABSORPTION = 5  # [1/m]
EMISSIVITY = 0.8
WALL = 400.0  # [K]
SOURCE = 2e5  # in the middle cubes [W/m^3]
STEP = 20.0  # [s]
STEPS_BETWEEN = 5  # between two runs of etendue

# The six tetrahedra around the diagonal of a cube (Kuhn 1960): those of neighbors share whole faces.
PATHS = list(itertools.permutations(range(3)))
EVEN_PATHS = ((0, 1, 2), (1, 2, 0), (2, 0, 1))


def block():
    """The mesh. Each cube is a region, named by its number."""
    corners = [count + 1 for count in CUBES]
    number = numpy.arange(numpy.prod(corners)).reshape(corners)
    points = SIDE * numpy.stack(numpy.unravel_index(number.ravel(), corners), axis=1)
    cells, regions = [], []
    for cube, place in enumerate(numpy.ndindex(*CUBES)):
        for path in PATHS:
            corner = numpy.array(place)
            cell = [int(number[tuple(corner)])]
            for axis in path:
                corner[axis] += 1
                cell.append(int(number[tuple(corner)]))
            # The others have their points in the order of a mirror image.
            cells.append(cell if path in EVEN_PATHS else [*cell[:2], cell[3], cell[2]])
            regions.append(str(cube))
    return etendue.Mesh(points, cells, region=regions)


def radiated(mesh, temperature):
    """Divergence of the radiative heat flux in each cube [W/m^3]."""
    case = {
        "media": {str(cube): {"absorption": ABSORPTION, "temperature": float(kelvin), "uncollided": False}
                  for cube, kelvin in enumerate(temperature.ravel())},
        "walls": {"boundary": {"emissivity": EMISSIVITY, "temperature": WALL, "uncollided": False}},
        "directions": {"set": "product", "order": 4},
    }
    solution = etendue.solve(case, mesh=mesh)
    net = {row["name"]: row["net"] / row["extent"] for row in solution.heat if row["kind"] == "region"}
    return numpy.array([net[str(cube)] for cube in range(temperature.size)]).reshape(temperature.shape)


def conducted(temperature):
    """Heat that conduction brings to each cube [W/m^3]; walls are half a cube away."""
    heat = numpy.zeros_like(temperature)
    for axis in range(3):
        along = numpy.moveaxis(temperature, axis, 0)
        flux = CONDUCTIVITY / SIDE * numpy.diff(along, axis=0)
        first, last = (2 * CONDUCTIVITY / SIDE * (side - WALL) for side in (along[:1], along[-1:]))
        flux = numpy.concatenate([first, flux, -last])
        heat += numpy.moveaxis(numpy.diff(flux, axis=0), 0, axis) / SIDE
    return heat


def run(steps):
    """Temperatures after these steps [K], and the heat that the last one kept, per volume of each cube [W/m^3]."""
    mesh = block()
    source = numpy.zeros(CUBES)
    source[2:4, 1, 1] = SOURCE
    temperature = numpy.full(CUBES, WALL)
    for step in range(steps):
        if step % STEPS_BETWEEN == 0:
            divergence = radiated(mesh, temperature)
        gain = source + conducted(temperature) - divergence
        temperature = temperature + STEP * gain / HEAT_CAPACITY
    return temperature, gain


def main():
    for steps in (50, 100, 200):
        temperature, gain = run(steps)
        print(f"after {steps * STEP:5.0f} s: middle {temperature[2, 1, 1]:.1f} K, corner {temperature[0, 0, 0]:.1f} K, "
              f"{gain.sum() / (2 * SOURCE):.1%} of the heat still warms the block")


if __name__ == "__main__":
    main()
