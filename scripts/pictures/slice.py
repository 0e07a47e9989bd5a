# SPDX-License-Identifier: AGPL-3.0-or-later
"""A field on a plane through the mesh, in false colours."""

import matplotlib

matplotlib.use("Agg")
import numpy  # noqa: E402
from matplotlib import colors, pyplot, tri  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkPlane  # noqa: E402
from vtkmodules.vtkFiltersCore import vtkCutter  # noqa: E402

from pictures.results import array, band_names, read_fields  # noqa: E402

AXES = "xyz"
LONGEST = 8  # sides: longer cuts, as those of columns, are drawn wider than they are


def draw_slice(results, options):
    bands = band_names(results)
    band = options.band or bands[0]
    if band not in bands:
        raise SystemExit(f"draw: no band {band}; there are {', '.join(bands)}")
    cut = cut_plane(read_fields(results), options.normal, options.at)
    points = vtk_to_numpy(cut.GetPoints().GetData())
    across = [k for k in range(3) if AXES[k] != options.normal]
    values = array(cut.GetPointData(), options.array)[:, bands.index(band)]
    triangles = vtk_to_numpy(cut.GetPolys().GetConnectivityArray()).reshape(-1, 3)

    figure, axes = pyplot.subplots(figsize=(7, 6), constrained_layout=True)
    mesh = tri.Triangulation(points[:, across[0]], points[:, across[1]], triangles)
    shown = axes.tripcolor(mesh, numpy.maximum(values, floor_of(values)) if options.log else values,
                           shading="gouraud", cmap="inferno", norm=norm_of(values, options.log), rasterized=True)
    sides = numpy.ptp(points[:, across], axis=0)
    axes.set_aspect("equal" if sides.max() < LONGEST * sides.min() else "auto")
    axes.set_xlabel(AXES[across[0]])
    axes.set_ylabel(AXES[across[1]])
    axes.set_title(options.title or f"{options.normal} = {options.at:g}")
    label = options.array if len(bands) == 1 else f"{options.array}, band {band}"
    figure.colorbar(shown, ax=axes, label=label, shrink=0.85)
    figure.savefig(options.output, dpi=130)
    pyplot.close(figure)


def floor_of(values):
    """Logarithmic colours end seven decades below the largest value."""
    return 1e-7 * values.max()


def norm_of(values, logarithmic):
    if logarithmic:
        return colors.LogNorm(max(values[values > 0].min(), floor_of(values)), values.max())
    # Of what is constant but for rounding no colours are made.
    constant = values.max() - values.min() <= 1e-6 * abs(values.max())
    return colors.Normalize(min(0, values.max()) if constant else values.min(), values.max())


def cut_plane(fields, normal, at):
    plane = vtkPlane()
    plane.SetNormal(*(1.0 if axis == normal else 0.0 for axis in AXES))
    plane.SetOrigin(*(at if axis == normal else 0.0 for axis in AXES))
    cutter = vtkCutter()
    cutter.SetCutFunction(plane)
    cutter.SetInputData(fields)
    cutter.GenerateTrianglesOn()
    cutter.Update()
    if cutter.GetOutput().GetNumberOfCells() == 0:
        raise SystemExit(f"draw: the plane {normal} = {at:g} does not cut the mesh")
    return cutter.GetOutput()
