# SPDX-License-Identifier: AGPL-3.0-or-later
"""Meshes from arrays and files."""

import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

from etendue import _etendue

_NONE = numpy.empty(0, dtype=numpy.int32)


def Mesh(points: ArrayLike, cells: ArrayLike, region: Sequence[str] | NDArray[Any] | None = None,  # noqa: N802 (as a class)
         walls: Mapping[str, ArrayLike] | None = None) -> _etendue.Mesh:
    """A conforming tetrahedral mesh. Cells and points are renumbered: those of fields are the mesh's.

    points   (n, 3) coordinates [length]
    cells    (m, 4) index of a point
    region   (m,) name of the region of each cell; default "medium"
    walls    { name: (k, 3) index of a point }, triangles on the boundary or between cells; without any the whole boundary
             is "boundary"

    Raises InputError where cells have no volume, faces do not conform, or a part of the boundary has no wall.
    """
    names, numbers = (["medium"], _NONE) if region is None else _numbered(region)
    walls = walls or {}
    triangles = [numpy.asarray(corners, dtype=numpy.int32).reshape(-1, 3) for corners in walls.values()]
    of_walls = [numpy.full(len(corners), k, dtype=numpy.int32) for k, corners in enumerate(triangles)]
    return _etendue.Mesh.from_arrays(
        numpy.asarray(points, dtype=float).reshape(-1, 3), numpy.asarray(cells, dtype=numpy.int32).reshape(-1, 4), numbers, names,
        numpy.concatenate(triangles) if triangles else _NONE, numpy.concatenate(of_walls) if of_walls else _NONE, list(walls))


def _numbered(region: Sequence[str] | NDArray[Any]) -> tuple[list[str], NDArray[numpy.int32]]:
    names, numbers = numpy.unique(numpy.asarray(region).astype(str), return_inverse=True)
    return names.tolist(), numbers.astype(numpy.int32)


def read_mesh(file: str | os.PathLike[str], scale: float = 1.0) -> _etendue.Mesh:
    """A mesh of a file: Gmsh .msh, VTK .vtu or TetGen .node; coordinates are multiplied by `scale`."""
    return _etendue.Mesh.from_file(file, scale)


def from_meshio(mesh: Any) -> _etendue.Mesh:
    """A mesh of a meshio.Mesh with tetrahedra: regions and walls are its cell sets, by their names, of tetrahedra and triangles."""
    blocks = [(block.type, numpy.asarray(block.data)) for block in mesh.cells]
    cells = [data for kind, data in blocks if kind == "tetra"]
    if not cells:
        raise ValueError("the mesh has no tetrahedra")
    region = numpy.full(sum(map(len, cells)), "medium", dtype=object)
    walls: dict[str, list[NDArray[Any]]] = {}
    for name, chosen in mesh.cell_sets.items():
        first = 0
        for (kind, data), rows in zip(blocks, chosen):
            if kind == "tetra":
                if rows is not None:
                    region[first + numpy.asarray(rows, dtype=int)] = name
                first += len(data)
            elif kind == "triangle" and rows is not None and len(rows) > 0:
                walls.setdefault(name, []).append(data[numpy.asarray(rows, dtype=int)])
    return Mesh(mesh.points, numpy.concatenate(cells), region, {name: numpy.concatenate(parts) for name, parts in walls.items()})
