# SPDX-License-Identifier: AGPL-3.0-or-later
"""Heat fluxes at both plates, and the temperature between the layers in the middle."""

import numpy
from pictures.results import read_fields
from vtkmodules.util.numpy_support import vtk_to_numpy

from suite.result import read_reference
from suite.row import Row

HOT = 1000.0  # [K]
BLACK = 5.670374419e-8 * HOT ** 4  # [W/m^2]


def compare(runs):
    found = []
    for row in read_reference("conduction_slab.csv"):
        name = f"tau {row['tau']} N {row['N']} theta2 {row['theta2']}"
        if name not in runs:
            continue
        for label, value in values(runs[name], row["quantity"]):
            curve = f"tau {row['tau']}, {1000 * float(row['theta2']):g} K"
            found.append(Row(f"{label}, {name}", value, float(row["value"]), float(row["uncertainty"]),
                             plot="heat flux" if label == "q into the cold plate" else "", curve=curve, x=float(row["N"])))
    return found


def values(result, quantity):
    """What is compared with a row of the table, and its name."""
    radiative = {wall: result.heat(wall, "density") / BLACK for wall in ("zmin", "zmax")}
    conducted = {wall: result.heat(wall, "conducted") / result.heat(wall, "extent") / BLACK for wall in radiative}
    if quantity == "q":
        return [("q out of the hot plate", -radiative["zmin"] - conducted["zmin"]),
                ("q into the cold plate", radiative["zmax"] + conducted["zmax"])]
    if quantity == "radiative":
        return [("radiative flux at the hot plate", -radiative["zmin"])]
    return [("theta in the middle", middle_temperature(result) / HOT)]


def middle_temperature(result):
    """Mean of the cells on both sides of the middle plane, whose six on each side fill a layer."""
    grid = read_fields(result.folder)
    kelvin = vtk_to_numpy(grid.GetCellData().GetArray("temperature"))
    points = vtk_to_numpy(grid.GetPoints().GetData())
    cells = points[vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)]
    touching = numpy.abs(cells[:, :, 2] - 0.5).min(axis=1) < 1e-9
    return float(kelvin[touching].mean())
