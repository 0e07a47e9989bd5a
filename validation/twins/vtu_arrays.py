# SPDX-License-Identifier: AGPL-3.0-or-later
"""Arrays of a VTK file of an unstructured grid."""

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def read(path):
    """Every array of the file by its name, points and cells included; texts as lists."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    mesh = reader.GetOutput()
    found = {"points": vtk_to_numpy(mesh.GetPoints().GetData()), "types": vtk_to_numpy(mesh.GetCellTypesArray()),
             "connectivity": vtk_to_numpy(mesh.GetCells().GetConnectivityArray()),
             "offsets": vtk_to_numpy(mesh.GetCells().GetOffsetsArray())}
    for data in (mesh.GetFieldData(), mesh.GetPointData(), mesh.GetCellData()):
        for k in range(data.GetNumberOfArrays()):
            array = data.GetAbstractArray(k)
            texts = array.GetDataTypeAsString() == "string"
            found[array.GetName()] = ([array.GetValue(i) for i in range(array.GetNumberOfValues())] if texts
                                      else vtk_to_numpy(array))
    return found
