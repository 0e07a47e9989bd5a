# SPDX-License-Identifier: AGPL-3.0-or-later
"""A medium as a cloud in front of a picture: what it scatters towards the eye, and what it hides."""

import math

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkResampleToImage

from pictures.results import array
from pictures.tone import as_rgb

VOXELS = 120  # along the longest side of the cloud
STEPS = 160   # of a ray through the whole cloud
COEFFICIENTS = ("absorption", "scattering")


class Cloud:
    """Extinction and scattered radiance, sigma_s phi / (4 pi), on a regular grid around the cells that have an
    extinction. Towards the eye light scatters as if evenly: the fields keep no more than the fluence."""

    def __init__(self, fields):
        absorption, scattering = (as_rgb(array(fields.GetCellData(), name)) for name in COEFFICIENTS)
        extinction = absorption + scattering
        self.bounds = bounds_of(fields, extinction.max(axis=1) > 0)
        for name, values in (("extinction", extinction), ("scattering rgb", scattering)):
            data = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
            data.SetName(name)
            fields.GetCellData().AddArray(data)
        image = resample(fields, self.bounds)
        shape = (*image.GetDimensions()[::-1], 3)
        samples = {name: as_rgb(array(image.GetPointData(), name))
                   for name in ("extinction", "scattering rgb", "fluence")}
        source = samples["scattering rgb"] * samples["fluence"] / (4 * math.pi)
        self.values = numpy.concatenate(
            [samples["extinction"].reshape(shape), source.reshape(shape)], axis=3).astype(numpy.float32)

    def add(self, picture, eye, targets):
        """`picture` [ray][3] is the radiance that arrives without the cloud, from the point `targets` [ray][3]."""
        way = targets - eye
        length = numpy.linalg.norm(way, axis=1)
        start, end = self.crossing(eye, way)
        inside = numpy.flatnonzero(end > start)
        way, length, start, end = way[inside], length[inside], start[inside], end[inside]
        step = (end - start) / STEPS
        transmitted = numpy.ones((len(inside), 3), dtype=numpy.float32)
        scattered = numpy.zeros((len(inside), 3), dtype=numpy.float32)
        for k in range(STEPS):
            values = self.at(eye + (start + (k + 0.5) * step)[:, None] * way)
            opacity = 1 - numpy.exp(-values[:, :3] * (step * length)[:, None])
            share = numpy.divide(opacity, values[:, :3], out=numpy.zeros_like(opacity), where=values[:, :3] > 0)
            scattered += transmitted * share * values[:, 3:]
            transmitted *= 1 - opacity
        picture[inside] = picture[inside] * transmitted + scattered

    def crossing(self, eye, way):
        """Where rays enter and leave the grid, in lengths of `way`; they end at 1."""
        with numpy.errstate(divide="ignore"):
            low, high = (self.bounds[::2] - eye) / way, (self.bounds[1::2] - eye) / way
        start = numpy.minimum(low, high).max(axis=1)
        end = numpy.maximum(low, high).min(axis=1)
        return numpy.maximum(start, 0), numpy.minimum(end, 1)

    def at(self, points):
        """Values at points, trilinear."""
        count = numpy.array(self.values.shape[2::-1])
        place = (points - self.bounds[::2]) / (self.bounds[1::2] - self.bounds[::2]) * (count - 1)
        first = numpy.clip(place.astype(int), 0, count - 2)
        part = numpy.clip(place - first, 0, 1).astype(numpy.float32)
        total = 0
        for corner in numpy.ndindex(2, 2, 2):
            weight = numpy.prod(numpy.where(corner, part, 1 - part), axis=1)
            x, y, z = (first + corner).T
            total = total + weight[:, None] * self.values[z, y, x]
        return total


def has_cloud(fields):
    """Whether the coefficients were written (output.fields has "media") and some are positive."""
    cells = fields.GetCellData()
    return all(cells.HasArray(name) for name in COEFFICIENTS) and any(
        array(cells, name).max() > 0 for name in COEFFICIENTS)


def bounds_of(fields, cells):
    """The box around these cells."""
    corners = vtk_to_numpy(fields.GetCells().GetConnectivityArray()).reshape(-1, 4)[cells]
    points = vtk_to_numpy(fields.GetPoints().GetData())[corners.ravel()]
    return numpy.column_stack([points.min(axis=0), points.max(axis=0)]).ravel()


def resample(fields, bounds):
    sides = bounds[1::2] - bounds[::2]
    sampler = vtkResampleToImage()
    sampler.SetInputDataObject(fields)
    sampler.UseInputBoundsOff()
    sampler.SetSamplingBounds(bounds)
    sampler.SetSamplingDimensions(*(max(2, math.ceil(VOXELS * side / max(sides))) for side in sides))
    sampler.Update()
    return sampler.GetOutput()
