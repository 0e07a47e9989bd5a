# SPDX-License-Identifier: AGPL-3.0-or-later
"""The content that VTK files of the program must have."""

import math
import xml.etree.ElementTree

from vtk_files.samples import TITLE

PER_BAND = "a component for each band"
VECTOR = "x, y, z; an array for each band"
# Point arrays by the name of the file, cell arrays the same; the number or meaning of their components.
POINTS = {"fields": {"fluence": PER_BAND, "net_flux": VECTOR, "color": 3},
          "walls": {"irradiance": PER_BAND, "exitance": PER_BAND, "net_irradiance": PER_BAND, "net_flux": VECTOR,
                    "color": 3},
          "irradiance": {"normal": 3, "color": 3},
          "set": {"weight": 1, "ordinate": 1}}
CELLS = {"fields": {"fluence_mean": PER_BAND},
         "difference": {"difference": PER_BAND, "error": PER_BAND, "difference_in_errors": PER_BAND},
         "solution": {"collided_fluence": None},
         "mesh": {"region": 1, "wall": 1}}
MORE_POINTS = {("by-ordinates", "fields"): {"radiance_0": PER_BAND},
               ("by-photons", "fields"): {"fluence_error": PER_BAND, "net_flux_error": VECTOR}}
MORE_CELLS = {("by-ordinates", "fields"): {"absorption": PER_BAND, "scattering": PER_BAND, "emission": PER_BAND},
              ("by-radiosity", "walls"): {"patch": 1}}
NAMED_CELLS = {"fields": ["region"], "difference": ["region"], "solution": ["region"], "walls": ["wall"],
               "mesh": ["region", "wall"]}
WITHOUT_BANDS = ("mesh", "set", "irradiance")
UNITS = {"fields": "fluence: W/cm^2", "walls": "exitance: W/cm^2", "difference": "error: W/cm^2", "set": "weight: sr"}


def read_by_vtk(path):
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
    reader = vtkXMLPolyDataReader() if path.suffix == ".vtp" else vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def read_by_paraview(path):
    """Opens a file as the program's window does and takes it to this process."""
    from paraview import servermanager, simple
    source = simple.OpenDataFile(str(path))
    source.UpdatePipeline()
    data = servermanager.Fetch(source)
    simple.Delete(source)
    return data


def faults_of(path, read):
    """Sentences about all that is wrong with a file; none where it is sound."""
    inline = "inline" in path.parts
    try:
        xml.etree.ElementTree.parse(path)
        faults = [] if inline else ["appended raw data is not there: the file is XML alone"]
    except xml.etree.ElementTree.ParseError as error:
        faults = [f"is not well-formed XML: {error}"] if inline else []
    data = read(path)
    if data is None or data.GetNumberOfPoints() == 0 or data.GetNumberOfCells() == 0:
        return faults + ["no points or cells could be read"]
    kind = path.stem.split("_")[0]
    return faults + array_faults(path, kind, data) + name_faults(kind, data) + field_faults(path, kind, data)


def texts(array):
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else None


def bands_of(path):
    return ["red & long", "<short>"] if "two-bands" in path.parts else ["grey"]


def array_faults(path, kind, data):
    bands = bands_of(path)
    place = (path.parent.name, kind)
    faults = []
    for arrays, count, wanted in (
            (data.GetPointData(), data.GetNumberOfPoints(), POINTS.get(kind, {}) | MORE_POINTS.get(place, {})),
            (data.GetCellData(), data.GetNumberOfCells(), CELLS.get(kind, {}) | MORE_CELLS.get(place, {}))):
        for name, layout in wanted.items():
            names = [f"{name}_{band}" for band in bands] if layout == VECTOR and len(bands) > 1 else [name]
            for each in names:
                faults += one_array_faults(arrays.GetArray(each), each, count, layout, bands)
    return faults


def one_array_faults(array, name, count, layout, bands):
    if array is None:
        return [f"no array {name}"]
    faults = []
    components = {PER_BAND: len(bands), VECTOR: 3}.get(layout, layout)
    if components is not None and array.GetNumberOfComponents() != components:
        faults.append(f"{name}: {array.GetNumberOfComponents()} components; must have {components}")
    if array.GetNumberOfTuples() != count:
        faults.append(f"{name}: {array.GetNumberOfTuples()} tuples; must have {count}")
    labels = {PER_BAND: bands, VECTOR: ["x", "y", "z"]}.get(layout, [])
    if labels and [array.GetComponentName(c) for c in range(len(labels))] != labels:
        faults.append(f"{name}: components are not named {labels}")
    if not all(math.isfinite(limit) for c in range(array.GetNumberOfComponents()) for limit in array.GetRange(c)):
        faults.append(f"{name}: values are not finite")
    return faults


def name_faults(kind, data):
    """Of regions and walls: the text beside each number must be its name."""
    faults = []
    for what in NAMED_CELLS.get(kind, []):
        names = texts(data.GetFieldData().GetAbstractArray(f"{what}_names"))
        numbers = data.GetCellData().GetArray(what)
        found = texts(data.GetCellData().GetAbstractArray(f"{what}_name"))
        if not names or numbers is None or not found:
            faults.append(f"no {what}_names, {what} or {what}_name")
            continue
        wanted = [int(numbers.GetTuple1(i)) for i in range(numbers.GetNumberOfTuples())]
        if found != [names[n] if n >= 0 else "" for n in wanted]:
            faults.append(f"{what}_name: not the names of {what}")
    return faults


def field_faults(path, kind, data):
    fields = data.GetFieldData()
    faults = []
    if texts(fields.GetAbstractArray("title")) != [TITLE]:
        faults.append("field data title: not the title of the case")
    if not (texts(fields.GetAbstractArray("program")) or [""])[0].startswith("etendue "):
        faults.append("field data program: not there")
    units = texts(fields.GetAbstractArray("units")) or []
    wanted = ([] if kind == "set" else ["coordinates: cm"]) + ([UNITS[kind]] if kind in UNITS else [])
    faults += [f"field data units: no line {line}" for line in wanted if line not in units]
    if kind in WITHOUT_BANDS:
        return faults
    if texts(fields.GetAbstractArray("band_names")) != bands_of(path):
        faults.append("field data band_names: not those of the case")
    edges = fields.GetArray("band_edges")
    found = [edges.GetTuple1(i) for i in range(edges.GetNumberOfTuples())] if edges else []
    if found != ([800, 600, 400] if len(bands_of(path)) > 1 else []):
        faults.append(f"field data band_edges: {found}")
    return faults
