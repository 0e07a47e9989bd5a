# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reads what a run wrote."""

import csv
import json

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader


def read_fields(results):
    """The tetrahedra of fields.vtu; each has points of its own."""
    return read_vtk(vtkXMLUnstructuredGridReader(), results / "fields.vtu")


def read_walls(results):
    """The triangles of walls.vtp; each has points of its own, counterclockwise as seen from outside."""
    return read_vtk(vtkXMLPolyDataReader(), results / "walls.vtp")


def read_vtk(reader, path):
    if not path.is_file():
        raise SystemExit(f"draw: {path}: there is no such file; run the case first")
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def band_names(results):
    with open(results / "summary.json", encoding="utf-8") as file:
        return json.load(file)["bands"]


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def array(data, name):
    """A data array as numbers [tuple][component]."""
    found = data.GetArray(name)
    if found is None:
        names = ", ".join(data.GetArrayName(i) for i in range(data.GetNumberOfArrays()))
        raise SystemExit(f"draw: no array {name}; there are {names}")
    return vtk_to_numpy(found).reshape(found.GetNumberOfTuples(), -1)
