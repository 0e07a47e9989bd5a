# SPDX-License-Identifier: AGPL-3.0-or-later
"""A sheet of upright bricks, six tetrahedra in each, for problems of two dimensions: as Gmsh mesh.

Bricks are as thick as is wanted between mirrors at z = 0 and the top, and as fine across as the solution wants them: light that
is turned back by mirrors close to each other takes a sweep for every turn. Walls are "side" below and above, and "xmin" … "ymax"."""

import itertools

import numpy

from suite.column import PATHS, heights


def planes(parts):
    found = [parts[0]["from"]]
    for part in parts:
        found += list(heights(part)[1:])
    return found


class Sheet:
    def __init__(self, data):
        self.x, self.y = planes(data["x"]), planes(data["y"])
        self.thickness = data["thickness"]
        self.regions = data["regions"]
        self.names = list(dict.fromkeys(region["name"] for region in self.regions))

    def vertex(self, i, j, k):
        return 2 * (j * len(self.x) + i) + k

    def points(self):
        return [(x, y, k * self.thickness) for y in self.y for x in self.x for k in (0, 1)]

    def bricks(self):
        return itertools.product(range(len(self.x) - 1), range(len(self.y) - 1))

    def region_of(self, i, j):
        """The last one that the middle of the brick lies in."""
        x, y = (self.x[i] + self.x[i + 1]) / 2, (self.y[j] + self.y[j + 1]) / 2
        inside = [r["name"] for r in self.regions if r["min"][0] < x < r["max"][0] and r["min"][1] < y < r["max"][1]]
        return self.names.index(inside[-1])

    def cells(self, i, j):
        """The six tetrahedra of a brick, of positive volume. All bricks are cut alike, so neighbours fit."""
        for path in PATHS:
            corners = numpy.cumsum([(0, 0, 0), *path], axis=0)
            found = [self.vertex(i + a, j + b, c) for a, b, c in corners]
            odd = numpy.linalg.det(numpy.array(path)) < 0
            yield [found[0], found[2], found[1], found[3]] if odd else found

    def wall_of(self, face):
        places = [(v // 2 % len(self.x), v // 2 // len(self.x), v % 2) for v in face]
        for axis, ends in enumerate(((0, len(self.x) - 1), (0, len(self.y) - 1), (0, 1))):
            for end, name in zip(ends, (("xmin", "xmax"), ("ymin", "ymax"), ("side", "side"))[axis]):
                if all(place[axis] == end for place in places):
                    return name
        raise ValueError(f"face {face} lies inside")


def write(path, data):
    sheet = Sheet(data)
    walls = ["side", "xmin", "xmax", "ymin", "ymax"]
    cells = [(sheet.region_of(i, j), cell) for i, j in sheet.bricks() for cell in sheet.cells(i, j)]
    count = {}
    for _, cell in cells:
        for face in itertools.combinations(sorted(cell), 3):
            count[face] = count.get(face, 0) + 1
    elements = [(2, walls.index(sheet.wall_of(face)) + 1, face) for face, times in count.items() if times == 1]
    elements += [(4, region + 1 + len(walls), cell) for region, cell in cells]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(walls) + len(sheet.names))]
    lines += [f'2 {k + 1} "{name}"' for k, name in enumerate(walls)]
    lines += [f'3 {k + 1 + len(walls)} "{name}"' for k, name in enumerate(sheet.names)]
    points = sheet.points()
    lines += ["$EndPhysicalNames", "$Nodes", str(len(points))]
    lines += [f"{number + 1} {x:.17g} {y:.17g} {z:.17g}" for number, (x, y, z) in enumerate(points)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{number + 1} {kind} 2 {tag} {tag} {' '.join(str(v + 1) for v in vertices)}"
              for number, (kind, tag, vertices) in enumerate(elements)]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join([*lines, "$EndElements", ""]), encoding="ascii")
