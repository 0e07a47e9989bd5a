# SPDX-License-Identifier: AGPL-3.0-or-later
"""A scene by the fvDOM of OpenFOAM: one step of thermoFoam with the temperature as it is given.

The linear solver of the temperature makes no iteration, so the step solves for radiation alone."""

import os
import re
import shutil

import numpy

from fvdom.runs import timed
from fvdom.scenes import STEFAN_BOLTZMANN

PROGRAM = "thermoFoam"
COLD = 1.0  # in place of 0 K, where a gas has no density [K]

SCHEMES = {"upwind": "bounded Gauss upwind", "linearUpwind": "bounded Gauss linearUpwind grad(Ii_h)"}
SOLVERS = {  # of the intensities; GAMG as in the tutorial hotRadiationRoomFvDOM
    "GAMG": "solver GAMG; smoother symGaussSeidel; nPostSweeps 1; maxIter 5;",
    "PBiCGStab": "solver PBiCGStab; preconditioner DILU; maxIter 1000;",
    "Gauss-Seidel": "solver smoothSolver; smoother symGaussSeidel; maxIter 1000;",
}

FILES = {
    "system/controlDict": """
        application thermoFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
        writeControl timeStep; writeInterval 1000; writeFormat ascii; writePrecision 12; runTimeModifiable no;
        functions { flux { type writeObjects; libs ("libutilityFunctionObjects.so"); objects (qr);
                           writeOption anyWrite; writeControl timeStep; writeInterval 1; } }""",
    "system/fvSchemes": """
        ddtSchemes { default steadyState; }
        gradSchemes { default Gauss linear; }
        divSchemes { default none; div(phi,h) bounded Gauss upwind; div(phi,K) bounded Gauss upwind;
                     div(Ji,Ii_h) %(scheme)s; }
        laplacianSchemes { default Gauss linear corrected; }
        interpolationSchemes { default linear; }
        snGradSchemes { default corrected; }""",
    "system/fvSolution": """
        solvers { Ii { %(solver)s tolerance 1e-4; relTol 0; }
                  h { solver PBiCGStab; preconditioner DILU; tolerance 1e-6; relTol 0; maxIter 0; } }
        SIMPLE { frozenFlow true; }
        PIMPLE { frozenFlow true; }""",
    "constant/thermophysicalProperties": """
        thermoType { type heRhoThermo; mixture pureMixture; transport const; thermo hConst;
                     equationOfState perfectGas; specie specie; energy sensibleEnthalpy; }
        pRef 100000;
        mixture { specie { molWeight 28.9; } thermodynamics { Cp 1000; Hf 0; } transport { mu 1.8e-5; Pr 0.7; } }""",
    "constant/turbulenceProperties": "simulationType laminar;",
    "constant/radiationProperties": """
        radiation on; radiationModel %(model)s; solverFreq 1;
        fvDOMCoeffs { nPhi %(n_phi)d; nTheta %(n_theta)d; tolerance 1e-3; maxIter 10; }
        absorptionEmissionModel constantAbsorptionEmission;
        constantAbsorptionEmissionCoeffs { absorptivity absorptivity [0 -1 0 0 0 0 0] %(absorption)g;
            emissivity emissivity [0 -1 0 0 0 0 0] %(absorption)g; E E [1 -1 -3 0 0 0 0] 0; }
        scatterModel none; sootModel none; transmissivityModel none;""",
    "constant/boundaryRadiationProperties": """
        ".*" { type lookup; emissivity %(emissivity)g; absorptivity %(emissivity)g; transmissivity 0; }""",
}

FIELDS = {  # class, dimensions, value inside, condition at walls
    "T": ("volScalarField", "[0 0 0 1 0 0 0]", None, "type fixedValue; value uniform %(wall_temperature)g;"),
    "p": ("volScalarField", "[1 -1 -2 0 0 0 0]", "uniform 1e5", "type zeroGradient;"),
    "U": ("volVectorField", "[0 1 -1 0 0 0 0]", "uniform (0 0 0)", "type fixedValue; value uniform (0 0 0);"),
    "IDefault": ("volScalarField", "[1 0 -3 0 0 0 0]", "uniform 0", "type greyDiffusiveRadiation; value uniform 0;"),
    "G": ("volScalarField", "[1 0 -3 0 0 0 0]", "uniform 0", "type zeroGradient;"),
}


def missing(folder):
    """Why OpenFOAM cannot be run, or nothing."""
    if not shutil.which(PROGRAM):
        return f"{PROGRAM} of OpenFOAM is not on PATH; on Debian: apt-get install openfoam"
    if not (folder / "etc/controlDict").is_file():
        return f"{folder} is no folder of OpenFOAM: it has no etc/controlDict"
    return ""


class OpenFoam:
    """An installation, and the folder of its runs."""

    def __init__(self, installation, folder):
        self.folder = folder
        self.environment = {**os.environ, "WM_PROJECT_DIR": str(installation.resolve()), "OMP_NUM_THREADS": "1"}

    def run(self, scene, mesh, settings, name):
        """Solves a scene with nPhi, nTheta, scheme and solver: processor time, and fluxes into walls."""
        folder = self.folder / name
        shutil.rmtree(folder, ignore_errors=True)
        self._write_case(folder, scene, mesh, {"model": "fvDOM", **settings})
        return self._seconds(folder), read_boundary(folder / "1/qr")

    def seconds_without_radiation(self, scene, mesh, name):
        """Processor time of the same step with no radiation model."""
        folder = self.folder / name
        shutil.rmtree(folder, ignore_errors=True)
        settings = {"n_phi": 1, "n_theta": 2, "scheme": "upwind", "solver": "GAMG"}
        self._write_case(folder, scene, mesh, {"model": "none", **settings})
        return self._seconds(folder)

    def _seconds(self, folder):
        return timed([PROGRAM], folder, folder / "log", self.environment).processor

    def _write_case(self, folder, scene, mesh, settings):
        values = {**settings, "scheme": SCHEMES[settings["scheme"]], "solver": SOLVERS[settings["solver"]],
                  "absorption": scene.absorption, "emissivity": scene.emissivity,
                  "wall_temperature": max(scene.wall_temperature, COLD)}
        mesh.write(folder / "constant/polyMesh")
        for file, text in FILES.items():
            _write(folder / file, "dictionary", text % values)
        for field, (kind, dimensions, inside, wall) in FIELDS.items():
            inside = inside or _list(_temperatures(scene, mesh))
            _write(folder / "0" / field, kind, f"dimensions {dimensions};\ninternalField {inside};\n"
                   f'boundaryField {{ ".*" {{ {wall % values} }} }}')


def _temperatures(scene, mesh):
    """Temperature of each cell that emits as much as the scene's does on the mean."""
    return (numpy.pi / STEFAN_BOLTZMANN * mesh.cell_means(scene.radiance)) ** 0.25


def _list(values):
    return f"nonuniform List<scalar> {len(values)} (\n" + "\n".join(f"{value:.12g}" for value in values) + "\n)"


def _write(file, kind, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(f"FoamFile {{ version 2.0; format ascii; class {kind}; object {file.name}; }}\n{text}\n")


def read_boundary(file):
    """Values of a field on the one patch of the mesh."""
    text = file.read_text(encoding="utf-8")
    values = re.search(r"nonuniform List<scalar>\s*\d+\s*\(([^)]*)\)", text[text.index("boundaryField"):])
    return numpy.array(values[1].split(), dtype=float)
