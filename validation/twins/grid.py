# SPDX-License-Identifier: AGPL-3.0-or-later
"""A mesh of tetrahedra with named regions and walls: read from what `etendue mesh` writes, written as Gmsh mesh."""

import dataclasses

import numpy

from twins import vtu_arrays

TETRAHEDRON, TRIANGLE = 10, 5


@dataclasses.dataclass
class Grid:
    points: numpy.ndarray     # [vertex, 3]
    cells: numpy.ndarray      # [cell, 4]
    regions: numpy.ndarray    # number of its region, [cell]
    faces: numpy.ndarray      # [wall face, 3]
    walls: numpy.ndarray      # number of its wall, [wall face]
    region_names: list
    wall_names: list
    vertex_labels: numpy.ndarray  # numbers that vertices and cells keep when they are shuffled
    cell_labels: numpy.ndarray

    def moved(self, motion):
        """The image under a motion. One that mirrors inverts cells and wall faces; these are numbered in the other sense."""
        order = slice(None, None, -1) if motion.mirrors else slice(None)
        cells = self.cells[:, [1, 0, 2, 3]] if motion.mirrors else self.cells
        return dataclasses.replace(self, points=motion.places(self.points), cells=cells, faces=self.faces[:, order])

    def shuffled(self, draw):
        """The same mesh with vertices, cells, wall faces, regions and walls in another order."""
        vertices, cells, faces, regions, walls = (numpy.array(draw.shuffled(range(len(entries)))) for entries in
                                                  (self.points, self.cells, self.faces, self.region_names, self.wall_names))
        number = numpy.argsort(vertices)
        return Grid(self.points[vertices], number[self.cells[cells]], numpy.argsort(regions)[self.regions[cells]],
                    number[self.faces[faces]], numpy.argsort(walls)[self.walls[faces]],
                    [self.region_names[k] for k in regions], [self.wall_names[k] for k in walls],
                    self.vertex_labels[vertices], self.cell_labels[cells])

    def by_label(self, corners, values):
        """Values at the corners of cells in any order, [cell, 4, ...], by the labels of cells, corners by those of vertices.
        `corners` are their points, [cell, 4, 3]."""
        labels = dict(zip(map(tuple, self.points.tolist()), self.vertex_labels.tolist()))
        cells = {tuple(sorted(vertices)): label for vertices, label in
                 zip(self.vertex_labels[self.cells].tolist(), self.cell_labels.tolist())}
        found = numpy.empty_like(values)
        for points, entries in zip(corners.tolist(), values):
            vertices = [labels[tuple(point)] for point in points]
            found[cells[tuple(sorted(vertices))]] = entries[numpy.argsort(vertices)]
        return found

    def write(self, path):
        first = len(self.wall_names) + 1
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(first - 1 + len(self.region_names))]
        lines += [f'2 {k + 1} "{name}"' for k, name in enumerate(self.wall_names)]
        lines += [f'3 {k + first} "{name}"' for k, name in enumerate(self.region_names)]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(self.points))]
        lines += [f"{k + 1} {x!r} {y!r} {z!r}" for k, (x, y, z) in enumerate(self.points.tolist())]
        elements = [(2, wall + 1, face) for wall, face in zip(self.walls.tolist(), self.faces.tolist())]
        elements += [(4, region + first, cell) for region, cell in zip(self.regions.tolist(), self.cells.tolist())]
        lines += ["$EndNodes", "$Elements", str(len(elements))]
        lines += [f"{k + 1} {kind} 2 {tag} {tag} {' '.join(str(v + 1) for v in vertices)}"
                  for k, (kind, tag, vertices) in enumerate(elements)]
        path.write_text("\n".join([*lines, "$EndElements", ""]), encoding="ascii")


def read(path):
    arrays = vtu_arrays.read(path)
    types, vertices = arrays["types"], arrays["connectivity"]
    starts = arrays["offsets"][:-1]
    cells, faces = (starts[types == kind, None] + numpy.arange(count) for kind, count in ((TETRAHEDRON, 4), (TRIANGLE, 3)))
    points = arrays["points"]
    return Grid(points, vertices[cells], arrays["region"][types == TETRAHEDRON], vertices[faces],
                arrays["wall"][types == TRIANGLE], arrays["region_names"], arrays["wall_names"],
                numpy.arange(len(points)), numpy.arange(len(cells)))
