# SPDX-License-Identifier: AGPL-3.0-or-later
"""What fields.vtu holds at a point: the linear function of the cell that it lies in."""

import numpy
from pictures.results import read_fields
from vtkmodules.util.numpy_support import vtk_to_numpy


class Field:
    """A point array of a run, all its bands."""

    def __init__(self, folder, name):
        grid = read_fields(folder)
        data = grid.GetPointData().GetArray(name)
        self.bands = [data.GetComponentName(k) for k in range(data.GetNumberOfComponents())]
        self.values = vtk_to_numpy(data).reshape(data.GetNumberOfTuples(), -1)
        self.cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
        self.corners = vtk_to_numpy(grid.GetPoints().GetData())[self.cells]

    def at(self, point, band):
        """Its value in the cell whose smallest barycentric coordinate is the largest: the cell of the point, or one beside it."""
        edges = numpy.swapaxes(self.corners[:, 1:] - self.corners[:, :1], 1, 2)
        along = numpy.linalg.solve(edges, (numpy.asarray(point) - self.corners[:, 0])[..., None])[..., 0]
        parts = numpy.column_stack((1 - along.sum(axis=1), along))
        cell = parts.min(axis=1).argmax()
        return float(parts[cell] @ self.values[self.cells[cell], self.bands.index(band)])
