# SPDX-License-Identifier: AGPL-3.0-or-later
"""Meshes of the box for both programs: cells with their faces, and the files of an OpenFOAM polyMesh."""

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from fvdom.scenes import SIDES

TETRAHEDRON = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]]
HEXAHEDRON = [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]]


class PolyMesh:
    """Points, cells of one kind, and faces in the order of OpenFOAM: those between cells by owner and neighbor, then
    those on walls."""

    def __init__(self, points, cells, cell_faces):
        self.points, self.cells = points, cells
        every = cells[:, cell_faces].reshape(-1, len(cell_faces[0]))
        owner = numpy.repeat(numpy.arange(len(cells)), len(cell_faces))
        _, index, counts = numpy.unique(numpy.sort(every, axis=1), axis=0, return_inverse=True, return_counts=True)
        order = numpy.argsort(index.ravel(), kind="stable")
        starts = numpy.concatenate([[0], numpy.cumsum(counts)[:-1]])
        inner = order[starts[counts == 2]]
        neighbor = owner[order[starts[counts == 2] + 1]]
        sorting = numpy.lexsort((neighbor, owner[inner]))
        inner, self.neighbors = inner[sorting], neighbor[sorting]
        outer = numpy.sort(order[starts[counts == 1]])
        self.faces = self._outward(every, owner, numpy.concatenate([inner, outer]))
        self.owners = owner[numpy.concatenate([inner, outer])]

    def _outward(self, every, owner, chosen):
        faces, corners = every[chosen].copy(), self.points[every[chosen]]
        normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        away = corners.mean(axis=1) - self.points[self.cells[owner[chosen]]].mean(axis=1)
        inward = (normals * away).sum(axis=1) < 0
        faces[inward] = faces[inward][:, ::-1]
        return faces

    def wall_faces(self):
        """Corners of the faces on walls, [face, corner, 3]."""
        return self.points[self.faces[len(self.neighbors):]]

    def cell_means(self, function):
        """Mean of a function of points over each cell."""
        corners = self.points[self.cells]
        weights = _tetrahedron_weights() if self.cells.shape[1] == 4 else _hexahedron_weights()
        return sum(function(numpy.einsum("k,nkd->nd", weight, corners)) for weight in weights) / len(weights)

    def write(self, folder):
        folder.mkdir(parents=True)
        inner, count = len(self.neighbors), len(self.faces)
        note = f"nPoints: {len(self.points)} nCells: {len(self.cells)} nFaces: {count} nInternalFaces: {inner}"
        _write(folder / "points", "vectorField", [f"({x:.15g} {y:.15g} {z:.15g})" for x, y, z in self.points])
        size = self.faces.shape[1]
        _write(folder / "faces", "faceList", [f"{size}({' '.join(map(str, face))})" for face in self.faces.tolist()])
        _write(folder / "owner", "labelList", map(str, self.owners.tolist()), note)
        _write(folder / "neighbour", "labelList", map(str, self.neighbors.tolist()), note)
        _write(folder / "boundary", "polyBoundaryMesh",
               [f"walls {{ type wall; nFaces {count - inner}; startFace {inner}; }}"])


def _tetrahedron_weights():
    """Barycentric coordinates of 20 points that sample a tetrahedron evenly."""
    steps = [(a, b, c, 3 - a - b - c) for a in range(4) for b in range(4 - a) for c in range(4 - a - b)]
    return (numpy.array(steps) + 0.25) / 4


def _hexahedron_weights():
    """Trilinear weights of the centers of the 27 parts of a hexahedron."""
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
    middles = numpy.stack(numpy.meshgrid(*[[1 / 6, 1 / 2, 5 / 6]] * 3), axis=-1).reshape(-1, 1, 3)
    return numpy.where(corners == 1, middles, 1 - middles).prod(axis=2)


def _write(file, kind, lines, note=""):
    lines = list(lines)
    note = f'note "{note}"; ' if note else ""
    file.write_text(f"FoamFile {{ version 2.0; format ascii; class {kind}; {note}object {file.name}; }}\n"
                    f"{len(lines)}\n(\n" + "\n".join(lines) + "\n)\n")


def tetrahedra(mesh_file):
    """The tetrahedra of a mesh that etendue wrote."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(mesh_file))
    reader.Update()
    grid = reader.GetOutput()
    kinds = vtk_to_numpy(grid.GetCellTypesArray())
    starts = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[:-1][kinds == vtk.VTK_TETRA]
    nodes = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    return PolyMesh(points, nodes[starts[:, None] + numpy.arange(4)].astype(int), TETRAHEDRON)


def hexahedra(count):
    """Cubes, so many along the short sides of the box."""
    counts = (count * SIDES).astype(int)
    axes = [numpy.linspace(0, side, n + 1) for side, n in zip(SIDES, counts)]
    points = numpy.stack(numpy.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    number = numpy.arange(len(points)).reshape(counts + 1)
    low, high = slice(None, -1), slice(1, None)
    corners = [(low, low, low), (high, low, low), (high, high, low), (low, high, low),
               (low, low, high), (high, low, high), (high, high, high), (low, high, high)]
    return PolyMesh(points, numpy.stack([number[c] for c in corners], axis=-1).reshape(-1, 8), HEXAHEDRON)
