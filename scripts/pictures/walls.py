# SPDX-License-Identifier: AGPL-3.0-or-later
"""An array of the walls in false colours, as seen from a place."""

import matplotlib

matplotlib.use("Agg")
import numpy  # noqa: E402
from matplotlib import cm, colors, pyplot  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkRenderer  # noqa: E402

from pictures.results import array, band_names, read_walls  # noqa: E402
from pictures.room import aim, coloured_actor, default_eye, draw, facing_triangles, middle, smooth  # noqa: E402

PIXELS_PER_INCH = 110


def draw_walls(results, options):
    walls = read_walls(results)
    eye = numpy.array(options.eye or default_eye(walls.GetBounds(), options))
    surface, wall_of_point = facing_triangles(walls, eye)
    values, label = values_of(surface, options, band_names(results))
    if not options.as_solved:
        values = smooth(surface, wall_of_point, values[:, None])[:, 0]
    seen = values[numpy.unique(vtk_to_numpy(surface.GetPolys().GetConnectivityArray()))]
    low, high = options.range or (seen.min(), seen.max())
    norm = colors.Normalize(low, high)

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(coloured_actor(surface, numpy.uint8(255 * cm.inferno(norm(values))[:, :3])))
    aim(renderer.GetActiveCamera(), eye, numpy.array(options.look_at or middle(walls.GetBounds())), options.angle)
    renderer.ResetCameraClippingRange()
    picture, _ = draw(renderer, options.pixels)
    write(picture, cm.ScalarMappable(norm, "inferno"), label, options)


def values_of(surface, options, bands):
    """The numbers of an array at the points, and what they are called."""
    values = array(surface.GetPointData(), options.array)
    if values.shape[1] == 1:
        return values[:, 0], options.array
    band = options.band or bands[0]
    if values.shape[1] != len(bands) or band not in bands:
        raise SystemExit(f"draw: {options.array} has no band {band}; there are {', '.join(bands)}")
    return values[:, bands.index(band)], f"{options.array}, band {band}"


def write(picture, scale, label, options):
    width, height = options.pixels
    figure, axes = pyplot.subplots(figsize=(width / PIXELS_PER_INCH, height / PIXELS_PER_INCH), constrained_layout=True)
    axes.imshow(numpy.uint8(picture.reshape(height, width, 3)), origin="lower")
    axes.set_axis_off()
    axes.set_title(options.title or "")
    figure.colorbar(scale, ax=axes, label=label, shrink=0.85)
    figure.savefig(options.output, dpi=130)
    pyplot.close(figure)
