# SPDX-License-Identifier: AGPL-3.0-or-later
"""A scene by etendue."""

import json
import os

import vtk
from vtk.util.numpy_support import vtk_to_numpy

from fvdom.runs import timed

MESH = """
[mesh]
max_volume = 0.016

[[mesh.box]]
region = "gas"
min = [0, 0, 0]
max = [1, 1, 2]

[media.gas]
[walls."*"]
diffuse = 0
"""

CASE = """
[mesh]
file = "{mesh}"

[media.gas]
absorption = {absorption}
scattering = {scattering}
temperature = "{formula}"

[walls."*"]
emissivity = {emissivity}
temperature = {wall_temperature}
"""

OUTSIDE = ("read", "mesh", "write", "total")  # stages of a run that are not radiation


class Etendue:
    """The program, and the folder of its runs."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.environment = {**os.environ, "OMP_NUM_THREADS": "1"}

    def mesh(self, level):
        """File of the mesh with every cell of the coarsest one cut into eight, so many times."""
        file = self.folder / f"level-{level}.vtu"
        if not file.exists():
            case = self.folder / "mesh.toml"
            case.write_text(MESH)
            self._run(["mesh", case, "-o", file, "--set", f"mesh.refine={level}"], self.folder / "mesh.log")
        return file

    def run(self, scene, mesh_file, keys, name):
        """Solves a scene: processor time of the process and of radiation alone, and the folder of the results.

        The program tells the seconds of its stages by the clock; the share that the process had of the processor turns
        them into processor time.
        """
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        case = folder / "case.toml"
        case.write_text(CASE.format(mesh=mesh_file, absorption=scene.absorption, scattering=scene.scattering,
                                    formula=scene.formula, emissivity=scene.emissivity,
                                    wall_temperature=scene.wall_temperature))
        sets = [part for key, value in keys.items() for part in ("--set", f"{key}={value}")]
        whole = self._run(["run", case, "--output", folder / "results", "--no-estimate", "--progress", "plain",
                           "--threads", "1", *sets], folder / "log")
        stages = json.loads((folder / "results/summary.json").read_text())["seconds"]
        radiation = sum(stages[stage] for stage in stages if stage not in OUTSIDE)
        return whole.processor, radiation * whole.processor / whole.clock, folder / "results"

    def _run(self, arguments, log):
        return timed([self.program, *arguments], self.folder, log, self.environment)


def wall_fluxes(results):
    """Triangles of the walls [n, 3, 3], and the heat fluxes into them at their corners [n, 3]."""
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(results / "walls.vtp"))
    reader.Update()
    surface = reader.GetOutput()
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    return points[corners], vtk_to_numpy(surface.GetPointData().GetArray("radiative_heat_flux"))[corners].astype(float)
