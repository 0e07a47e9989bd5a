# SPDX-License-Identifier: AGPL-3.0-or-later
"""A look into a room: the walls in the light that leaves them, the medium as a translucent cloud."""

import math

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPiecewiseFunction, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkResampleToImage
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume,
                                         vtkVolumeProperty, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers what draws
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from pictures.results import array, read_fields, read_walls
from pictures.tone import as_rgb, tone_map

OVERSAMPLING = 2  # pixels of the drawing for one of the picture, in each direction
VOXELS = 120      # along the longest side of the cloud


def draw_room(results, options):
    walls, fields = read_walls(results), read_fields(results)
    eye = numpy.array(options.eye or default_eye(walls.GetBounds(), options))
    target = numpy.array(options.look_at or middle(walls.GetBounds()))
    surface = facing_triangles(walls, eye)
    radiance = smooth(surface, as_rgb(array(surface.GetPointData(), "exitance")) / math.pi)
    white = options.white or white_point(radiance)

    renderer = vtkRenderer()
    renderer.SetBackground(0.05, 0.05, 0.06)
    renderer.AddActor(coloured_actor(surface, tone_map(radiance, white)))
    cloud = cloud_volume(fields, white)
    if cloud:
        renderer.AddVolume(cloud)
    aim(renderer.GetActiveCamera(), eye, target, options.angle)
    renderer.ResetCameraClippingRange()
    save(renderer, options.pixels, options.output)


def middle(bounds):
    return [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2]


def default_eye(bounds, options):
    """In front of the side of smallest y, so far that its opening fills the picture."""
    x, _, z = middle(bounds)
    height = max(bounds[5] - bounds[4], (bounds[1] - bounds[0]) * options.pixels[1] / options.pixels[0])
    return [x, bounds[2] - 1.03 * height / (2 * math.tan(math.radians(options.angle) / 2)), z]


def facing_triangles(walls, eye):
    """Triangles whose inner side the eye sees. The others, such as a wall between the eye and the room, would
    hide the scene."""
    corners = triangle_corners(walls)
    points = vtk_to_numpy(walls.GetPoints().GetData())
    a, b, c = (points[corners[:, k]] for k in range(3))
    outward = numpy.cross(b - a, c - a)
    seen = numpy.einsum("ij,ij->i", outward, eye - a) < 0
    kept = corners[seen]
    cells = vtkCellArray()
    for triangle in kept:
        cells.InsertNextCell(3, triangle)
    surface = vtkPolyData()
    surface.ShallowCopy(walls)
    surface.SetPolys(cells)
    wall = numpy.repeat(vtk_to_numpy(walls.GetCellData().GetArray("wall"))[:, None], 3, axis=1)
    of_point = numpy.full(len(points), -1)
    of_point[corners] = wall
    surface.of_point = of_point
    return surface


def triangle_corners(walls):
    return vtk_to_numpy(walls.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def smooth(surface, values):
    """The mean of the values that meet in one place of one wall: hides the jumps between triangles, keeps those
    between walls."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    keys = numpy.column_stack([points.round(7), surface.of_point])
    _, group = numpy.unique(keys, axis=0, return_inverse=True)
    count = numpy.bincount(group)
    return numpy.column_stack([(numpy.bincount(group, weights=v) / count)[group] for v in values.T])


def white_point(radiance):
    """The luminance (Rec. 709) that nine tenths of the walls' points stay below."""
    return numpy.quantile(radiance @ numpy.array([0.2126, 0.7152, 0.0722]), 0.9)


def coloured_actor(surface, colours):
    scalars = numpy_to_vtk(numpy.ascontiguousarray(colours), deep=True, array_type=VTK_UNSIGNED_CHAR)
    surface.GetPointData().SetScalars(scalars)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def cloud_volume(fields, white):
    """Where the medium has an extinction: the colour of isotropically scattered light, phi/(4 pi), and the
    opacity of the extinction."""
    absorption = as_rgb(array(fields.GetCellData(), "absorption"))
    scattering = as_rgb(array(fields.GetCellData(), "scattering"))
    extinction = (absorption + scattering).mean(axis=1)
    if not extinction.max() > 0:
        return None
    fields.GetCellData().AddArray(named("extinction", extinction))
    image = resample(fields, bounds_of(fields, extinction > 0))
    albedo = (scattering.sum() / (absorption + scattering).sum())
    inside = vtk_to_numpy(image.GetPointData().GetArray("extinction"))
    fluence = as_rgb(array(image.GetPointData(), "fluence"))
    colours = tone_map(albedo * fluence / (4 * math.pi), white)
    share = numpy.rint(255 * inside / extinction.max()).astype(numpy.uint8)
    image.GetPointData().SetScalars(
        numpy_to_vtk(numpy.column_stack([colours, share]), deep=True, array_type=VTK_UNSIGNED_CHAR))
    volume = vtkVolume()
    mapper = vtkFixedPointVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.SetSampleDistance(min(image.GetSpacing()))
    mapper.SetAutoAdjustSampleDistances(0)
    volume.SetMapper(mapper)
    volume.SetProperty(translucency(extinction.max(), min(image.GetSpacing())))
    return volume


def translucency(extinction, length):
    """Opacity of a length of the medium, for the share 0..255 of the largest extinction."""
    opacity = vtkPiecewiseFunction()
    for share in range(0, 256, 15):
        opacity.AddPoint(share, 1 - math.exp(-extinction * share / 255 * length))
    volume = vtkVolumeProperty()
    volume.IndependentComponentsOff()
    volume.SetInterpolationTypeToLinear()
    volume.SetScalarOpacity(opacity)
    volume.SetScalarOpacityUnitDistance(length)
    return volume


def named(name, values):
    data = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    data.SetName(name)
    return data


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


def aim(camera, eye, target, angle):
    camera.SetPosition(*eye)
    camera.SetFocalPoint(*target)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)


def save(renderer, pixels, path):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*(OVERSAMPLING * n for n in pixels))
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    resize = vtkImageResize()
    resize.SetInputConnection(grab.GetOutputPort())
    resize.SetOutputDimensions(*pixels, 1)
    writer = vtkPNGWriter()
    writer.SetInputConnection(resize.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
