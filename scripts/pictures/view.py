# SPDX-License-Identifier: AGPL-3.0-or-later
"""A file of cells, walls or directions in a scene that can be turned: what scripts/view shows."""

import numpy
from matplotlib import colormaps
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList, vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkCutter, vtkGlyph3D, vtkTubeFilter
from vtkmodules.vtkFiltersExtraction import vtkExtractCells
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersModeling import vtkOutlineFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkRenderWindowInteractor, vtkTextActor, vtkWindowToImageFilter)
import vtkmodules.vtkRenderingFreeType  # noqa: F401  registers what writes text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers what draws

from pictures.results import array, read_vtk

LINES = 150  # of flow
DECADES = 5  # of logarithmic colours


class View:
    def __init__(self, options):
        self.options = options
        self.is_walls = options.file.suffix == ".vtp"
        self.data = read_vtk(vtkXMLPolyDataReader() if self.is_walls else vtkXMLUnstructuredGridReader(), options.file)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.window = vtkRenderWindow()
        self.window.SetSize(*options.pixels)
        self.window.SetMultiSamples(8)
        self.window.AddRenderer(self.renderer)
        self.bar = None

    def show(self):
        if self.data.GetPointData().HasArray("ordinate") and not self.data.GetCellData().HasArray("wall"):
            self.add_directions()
        elif self.options.flow:
            self.add_flow()
        else:
            self.add_cells()
        self.aim()
        if getattr(self.options, "label", None):
            self.add_label(self.options.label)
        if self.options.output:
            self.write()
        else:
            self.let_turn()

    def fail(self, problem):
        raise SystemExit(f"view: {self.options.file}: {problem}")

    def names(self, array_name):
        found = self.data.GetFieldData().GetAbstractArray(array_name)
        return [found.GetValue(i) for i in range(found.GetNumberOfValues())] if found else []

    def chosen(self):
        """The region or wall that is asked for; the whole without one."""
        kind = "wall" if self.is_walls else "region"
        name, names = self.options.name, self.names(kind + "_names")
        if not name:
            return self.data
        if name not in names:
            self.fail(f"no {kind} {name}; there are {', '.join(names)}")
        numbers = array(self.data.GetCellData(), kind)[:, 0]
        wanted = vtkIdList()
        for cell in numpy.flatnonzero(numbers == names.index(name)):
            wanted.InsertNextId(int(cell))
        extract = vtkExtractCells()
        extract.SetInputData(self.data)
        extract.SetCellList(wanted)
        extract.Update()
        return extract.GetOutput()

    def add_cells(self):
        shown = self.chosen()
        if self.options.slice:
            shown = self.cut(shown)
        surface = vtkGeometryFilter()
        surface.SetInputData(shown)
        surface.Update()
        actor = self.actor(surface.GetOutput())
        if self.is_walls and not self.options.name:
            # Triangles stand counterclockwise seen from outside: the wall between eye and room is left out.
            actor.GetProperty().FrontfaceCullingOn()
        self.renderer.AddActor(actor)
        if not self.is_walls:
            self.add_outline()

    def cut(self, data):
        axis, at = "xyz".index(self.options.slice[0]), float(self.options.slice[1])
        plane = vtkPlane()
        plane.SetNormal(*numpy.eye(3)[axis])
        plane.SetOrigin(*(at * numpy.eye(3)[axis]))
        cutter = vtkCutter()
        cutter.SetCutFunction(plane)
        cutter.SetInputData(data)
        cutter.Update()
        if cutter.GetOutput().GetNumberOfCells() == 0:
            self.fail(f"the plane {self.options.slice[0]} = {at:g} does not cut it")
        return cutter.GetOutput()

    def actor(self, surface):
        """A surface in the colours of an array; `color` holds colours as they are."""
        name = self.options.array or ("color" if self.is_walls and surface.GetPointData().HasArray("color") else
                                      "irradiance" if self.is_walls else "fluence")
        on_points = surface.GetPointData().HasArray(name)
        values = array(surface.GetPointData() if on_points or not surface.GetCellData().HasArray(name)
                       else surface.GetCellData(), name)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(surface)
        if on_points:
            mapper.SetScalarModeToUsePointFieldData()
        else:
            mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(name)
        if values.dtype == numpy.uint8:
            mapper.SetColorModeToDirectScalars()
        else:
            self.color(mapper, name, values)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        return actor

    def color(self, mapper, name, values):
        bands = self.names("band_names")
        band = self.options.band or (bands[0] if bands else "")
        if self.options.band and band not in bands:
            self.fail(f"no band {band}; there are {', '.join(bands)}")
        by_bands = values.shape[1] == len(bands)
        component = bands.index(band) if band in bands and by_bands else 0
        column = values[:, component]
        table = lookup_table(column, self.options.log, self.options.range)
        table.SetVectorModeToComponent()
        table.SetVectorComponent(component)
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        bar = vtkScalarBarActor()
        bar.SetLookupTable(table)
        bar.SetTitle(name + (f", {band}" if by_bands and len(bands) > 1 else ""))
        bar.SetComponentTitle("")
        bar.SetNumberOfLabels(5)
        bar.UnconstrainedFontSizeOn()
        for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
            text.SetColor(0, 0, 0)
            text.SetFontSize(14)
            text.ItalicOff()
            text.ShadowOff()
            text.BoldOff()
        bar.SetVerticalTitleSeparation(12)
        bar.SetPosition(0.86, 0.15)
        bar.SetWidth(0.08)
        bar.SetHeight(0.7)
        self.renderer.AddActor2D(bar)
        self.bar = bar

    def add_flow(self):
        """Lines along the net flux, both ways from points that are spread evenly over the cells' volume."""
        bands = self.names("band_names")
        band = self.options.band or (bands[0] if bands else "")
        name = f"net_flux_{band}" if len(bands) > 1 else "net_flux"
        array(self.data.GetPointData(), name)
        tracer = vtkStreamTracer()
        tracer.SetInputData(self.data)
        tracer.SetSourceData(self.seeds())
        tracer.SetInputArrayToProcess(0, 0, 0, 0, name)
        tracer.SetIntegrationDirectionToBoth()
        tracer.SetIntegratorTypeToRungeKutta45()
        tracer.SetMaximumPropagation(4 * self.data.GetLength())
        tubes = vtkTubeFilter()
        tubes.SetInputConnection(tracer.GetOutputPort())
        tubes.SetRadius(0.0015 * self.data.GetLength())
        tubes.SetNumberOfSides(8)
        tubes.Update()
        self.renderer.AddActor(self.actor(tubes.GetOutput()))
        self.add_outline()

    def seeds(self):
        low, high = numpy.array(self.data.GetBounds()).reshape(3, 2).T
        random = numpy.random.default_rng(1)
        locator = vtkStaticCellLocator()
        locator.SetDataSet(self.data)
        locator.BuildLocator()
        found = [p for p in low + (high - low) * random.random((4 * LINES, 3)) if locator.FindCell(p) >= 0][:LINES]
        seeds = vtkPolyData()
        places = vtkPoints()
        places.SetData(numpy_to_vtk(numpy.array(found), deep=True))
        seeds.SetPoints(places)
        return seeds

    def add_outline(self):
        """The box around all."""
        outline = vtkOutlineFilter()
        outline.SetInputData(self.data)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(outline.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.4, 0.4, 0.4)
        self.renderer.AddActor(actor)

    def add_directions(self):
        """Balls on the unit sphere, of the area that their weights stand for."""
        weights = array(self.data.GetPointData(), "weight")[:, 0]
        self.data.GetPointData().AddArray(named("radius", 0.35 * numpy.sqrt(weights / numpy.pi)))
        self.data.GetPointData().SetActiveScalars("radius")
        ball = vtkSphereSource()
        ball.SetThetaResolution(16)
        ball.SetPhiResolution(12)
        ball.SetRadius(1)
        glyphs = vtkGlyph3D()
        glyphs.SetInputData(self.data)
        glyphs.SetSourceConnection(ball.GetOutputPort())
        glyphs.SetScaleModeToScaleByScalar()
        glyphs.SetScaleFactor(1)
        glyphs.Update()
        self.options.array = self.options.array or "weight"
        actor = self.actor(glyphs.GetOutput())
        actor.GetProperty().LightingOn()
        self.renderer.AddActor(actor)
        sphere = vtkSphereSource()
        sphere.SetRadius(0.97)
        sphere.SetThetaResolution(96)
        sphere.SetPhiResolution(48)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(sphere.GetOutputPort())
        earth = vtkActor()
        earth.SetMapper(mapper)
        earth.GetProperty().SetColor(0.9, 0.9, 0.9)
        self.renderer.AddActor(earth)

    def aim(self):
        bounds = numpy.array(self.data.GetBounds()).reshape(3, 2)
        middle = bounds.mean(axis=1)
        eye = self.options.eye
        if eye is None:
            towards = numpy.array([0.45, -1, 0.45]) if not self.options.slice else facing(self.options.slice[0])
            eye = middle + towards * self.data.GetLength()
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*eye)
        camera.SetFocalPoint(*middle)
        camera.SetViewUp(0, 1 if self.options.slice and self.options.slice[0] == "z" else 0, 1)
        camera.SetParallelProjection(bool(self.options.slice))
        if self.options.eye is None:
            self.renderer.ResetCamera()
            camera.Zoom(1.15 if self.bar is None else 1.0)
        if self.bar is not None:
            camera.SetWindowCenter(0.12, 0)  # room for the bar at the right
        self.renderer.ResetCameraClippingRange()

    def add_label(self, text):
        label = vtkTextActor()
        label.SetInput(text)
        label.GetTextProperty().SetColor(0, 0, 0)
        label.GetTextProperty().SetFontSize(18)
        label.SetPosition(20, 20)
        self.renderer.AddActor2D(label)

    def write(self):
        self.window.SetOffScreenRendering(1)
        self.window.Render()
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(self.window)
        grabber.ReadFrontBufferOff()
        writer = vtkPNGWriter()
        writer.SetInputConnection(grabber.GetOutputPort())
        writer.SetFileName(str(self.options.output))
        writer.Write()

    def let_turn(self):
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(self.window)
        interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        self.window.SetWindowName(str(self.options.file))
        self.window.Render()
        interactor.Start()


def facing(axis):
    """Straight at a plane."""
    return {"x": numpy.array([1, 0, 0]), "y": numpy.array([0, -1, 0]), "z": numpy.array([0, 0, 1])}[axis]


def named(name, values):
    found = numpy_to_vtk(values, deep=True)
    found.SetName(name)
    return found


def lookup_table(values, logarithmic, asked=None):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    low, high = asked or (float(values.min()), float(values.max()))
    if logarithmic and asked:
        table.SetScaleToLog10()
    elif logarithmic:
        positive = values[values > 0]
        if len(positive) == 0:
            raise SystemExit("view: --log: no value is positive")
        low = max(float(positive.min()), high * 10.0 ** -DECADES)
        table.SetScaleToLog10()
    if low < 0 < high and not asked:
        low, high = -max(-low, high), max(-low, high)
    colors = colormaps["RdBu_r" if low == -high else "inferno"]
    for i in range(256):
        table.SetTableValue(i, *colors(i / 255))
    table.SetTableRange(low, high if high > low else low + 1)
    return table
