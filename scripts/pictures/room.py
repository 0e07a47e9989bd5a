# SPDX-License-Identifier: AGPL-3.0-or-later
"""A look into a room: the walls in the light that leaves them, the medium as a translucent cloud."""

import itertools
import math

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers what draws

from pictures.cloud import Cloud, has_cloud
from pictures.results import array, read_fields, read_walls
from pictures.tone import as_rgb, display_values, linear_values

OVERSAMPLING = 3  # pixels of the drawing for one of the picture, in each direction
BACKGROUND = (0.05, 0.05, 0.06)


def draw_room(results, options):
    walls, fields = read_walls(results), read_fields(results)
    eye = numpy.array(options.eye or default_eye(walls.GetBounds(), options))
    target = numpy.array(options.look_at or middle(walls.GetBounds()))
    surface, wall_of_point = facing_triangles(walls, eye)
    radiance = as_rgb(array(surface.GetPointData(), "exitance")) / math.pi
    if not options.as_solved:
        radiance = smooth(surface, wall_of_point, radiance)
    bright = options.bright or bright_point(radiance)

    renderer = vtkRenderer()
    renderer.SetBackground(*BACKGROUND)
    renderer.AddActor(coloured_actor(surface, display_values(radiance, bright)))
    aim(renderer.GetActiveCamera(), eye, target, options.angle)
    renderer.ResetCameraClippingRange()
    picture, points = draw(renderer, options.pixels)
    picture = linear_values(picture, bright)
    if has_cloud(fields):
        Cloud(fields).add(picture, eye, points)
    write(display_values(picture, bright), options.pixels, options.output)


def middle(bounds):
    return [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2]


def default_eye(bounds, options):
    """In front of the side of smallest y, so far that its opening fills the picture."""
    x, _, z = middle(bounds)
    height = max(bounds[5] - bounds[4], (bounds[1] - bounds[0]) * options.pixels[1] / options.pixels[0])
    return [x, bounds[2] - 1.03 * height / (2 * math.tan(math.radians(options.angle) / 2)), z]


def facing_triangles(walls, eye):
    """Triangles whose inner side the eye sees, and the wall of each point. The others, such as a wall between the
    eye and the room, would hide the scene."""
    corners = vtk_to_numpy(walls.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(walls.GetPoints().GetData())
    a, b, c = (points[corners[:, k]] for k in range(3))
    outward = numpy.cross(b - a, c - a)
    cells = vtkCellArray()
    for triangle in corners[numpy.einsum("ij,ij->i", outward, eye - a) < 0]:
        cells.InsertNextCell(3, triangle)
    surface = vtkPolyData()
    surface.ShallowCopy(walls)
    surface.SetPolys(cells)
    wall_of_point = numpy.full(len(points), -1)
    wall_of_point[corners] = vtk_to_numpy(walls.GetCellData().GetArray("wall"))[:, None]
    return surface, wall_of_point


def smooth(surface, wall_of_point, values):
    """The mean of the values that meet in one place of one wall: hides the jumps between triangles, keeps those
    between walls and where a sheet stands on a wall."""
    group = joined_corners(surface, wall_of_point)
    count = numpy.bincount(group)
    return numpy.column_stack([(numpy.bincount(group, weights=v) / count)[group] for v in values.T])


def joined_corners(surface, wall_of_point):
    """[point] a number that corners have in common which meet in one place of one wall and are joined by edges on
    which nothing stands."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    _, place = numpy.unique(points.round(7), axis=0, return_inverse=True)
    around = {}
    for triangle in triangles:
        for k in range(3):
            ends = sorted(numpy.roll(triangle, -k)[1:], key=lambda i: place[i])
            around.setdefault(tuple(place[ends]), []).append(Side(points, triangle, triangle[k], ends))
    group = numpy.arange(len(points))

    def root(i):
        while group[i] != i:
            i = group[i]
        return i

    for sides in around.values():
        for a, b in itertools.combinations(sides, 2):
            if wall_of_point[a.tip] == wall_of_point[b.tip] and not are_parted(a, b, sides):
                for i, j in zip(a.ends, b.ends):
                    group[root(i)] = root(j)
    return numpy.unique([root(i) for i in range(len(points))], return_inverse=True)[1]


class Side:
    """A triangle as one of those around an edge."""

    def __init__(self, points, triangle, tip, ends):
        self.tip, self.ends = tip, ends
        a, b, c = points[triangle]
        normal = numpy.cross(c - a, b - a)  # corners stand counterclockwise outside of the room
        self.inward = normal / numpy.linalg.norm(normal)
        self.away = points[tip] - points[ends[0]]  # from the edge
        self.size = numpy.linalg.norm(self.away)


def are_parted(a, b, sides):
    """Whether another triangle stands between the fronts of two that meet at an edge."""
    return any(side is not a and side is not b and
               all(front @ side.away > 1e-6 * side.size for front in (a.inward, b.inward)) for side in sides)


def bright_point(radiance):
    """The luminance (Rec. 709) that nine tenths of the walls' points stay below."""
    return numpy.quantile(radiance @ numpy.array([0.2126, 0.7152, 0.0722]), 0.9)


def coloured_actor(surface, colours):
    surface.GetPointData().SetScalars(numpy_to_vtk(colours, deep=True, array_type=VTK_UNSIGNED_CHAR))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def aim(camera, eye, target, angle):
    camera.SetPosition(*eye)
    camera.SetFocalPoint(*target)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)


def draw(renderer, pixels):
    """Colours [pixel][3] and the places that are seen there [pixel][3], row by row from below."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*(OVERSAMPLING * n for n in pixels))
    window.AddRenderer(renderer)
    window.Render()
    colours = grab(window, vtkWindowToImageFilter.SetInputBufferTypeToRGB, pixels).mean(axis=(1, 3))
    depth = grab(window, vtkWindowToImageFilter.SetInputBufferTypeToZBuffer, pixels)
    middle_of_pixel = OVERSAMPLING // 2
    points = places(renderer, depth[:, middle_of_pixel, :, middle_of_pixel, 0], pixels)
    return colours.reshape(-1, 3), points


def grab(window, choose_buffer, pixels):
    """What is in the window, [row][row in the pixel][column][column in the pixel][component]."""
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    choose_buffer(grabber)
    grabber.Update()
    values = vtk_to_numpy(grabber.GetOutput().GetPointData().GetScalars())
    return values.reshape(pixels[1], OVERSAMPLING, pixels[0], OVERSAMPLING, -1)


def places(renderer, depth, pixels):
    """From the depth buffer to coordinates, through the inverse of the camera's projection."""
    camera = renderer.GetActiveCamera()
    inverse = vtkMatrix4x4()
    vtkMatrix4x4.Invert(camera.GetCompositeProjectionTransformMatrix(pixels[0] / pixels[1], -1, 1), inverse)
    matrix = numpy.array([[inverse.GetElement(i, j) for j in range(4)] for i in range(4)])
    x = (numpy.arange(pixels[0]) + 0.5) / pixels[0] * 2 - 1
    y = (numpy.arange(pixels[1]) + 0.5) / pixels[1] * 2 - 1
    view = numpy.stack([*numpy.meshgrid(x, y), 2 * depth - 1, numpy.ones_like(depth)], axis=-1).reshape(-1, 4)
    world = view @ matrix.T
    return world[:, :3] / world[:, 3:]


def write(colours, pixels, path):
    image = vtkImageData()
    image.SetDimensions(*pixels, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(colours, deep=True, array_type=VTK_UNSIGNED_CHAR))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()
