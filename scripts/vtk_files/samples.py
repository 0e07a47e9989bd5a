# SPDX-License-Identifier: AGPL-3.0-or-later
"""Writes files of every kind that the program knows, in both encodings."""

import subprocess

ENCODINGS = ("inline", "appended")
TITLE = 'Room & "smoke" <1>'
BANDS = {"grey": "", "two-bands": '[bands]\nnames = ["red & long", "<short>"]\nedges = [800, 600, 400]\n'}
CASE = """title = 'Room & "smoke" <1>'
[units]
length = "cm"
[mesh]
max_volume = 0.05
[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [1, 1, 1]
walls = { zmin = "floor", zmax = "ceiling" }
[[mesh.box]]
region = "smoke"
min = [0.25, 0.25, 0.25]
max = [0.75, 0.75, 0.75]
[media.air]
[media.smoke]
absorption = 0.5
scattering = 1.0
[walls.floor]
radiance = 1.0
[walls.ceiling]
diffuse = 0.5
[walls."*"]
diffuse = 0.2
[directions]
set = "product"
order = 2
[solve]
tolerance = 1e-3
"""
EMPTY = ["--set", "media.smoke.absorption=0", "--set", "media.smoke.scattering=0"]
RUNS = {"by-ordinates": ["--set", 'output.fields=["fluence","net_flux","media","radiance:0"]'],
        "by-photons": ["--set", 'solve.method="photons"', "--set", "solve.photons=2000"],
        "by-radiosity": EMPTY + ["--set", 'solve.method="radiosity"', "--set", "radiosity.patch_size=0.2", "--set",
                              "radiosity.passes=2"]}


def etendue(program, *arguments):
    done = subprocess.run([str(program), *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"check_vtk_files: etendue {' '.join(map(str, arguments))}: exit code {done.returncode}\n"
                         f"{done.stdout}{done.stderr}")


def write_samples(program, folder):
    """FOLDER/ENCODING/BANDS/…: results of each method, of bake, compare, mesh and directions."""
    for encoding in ENCODINGS:
        for bands, lines in BANDS.items():
            place = folder / encoding / bands
            place.mkdir(parents=True)
            case = place / "case.toml"
            case.write_text(CASE + lines + f'[output]\nencoding = "{encoding}"\n', encoding="utf-8")
            for method, settings in RUNS.items():
                etendue(program, "run", case, "--output", place / method, *settings)
            etendue(program, "bake", place / "by-ordinates")
            etendue(program, "compare", case, "--methods", "ordinates,photons", "--set", "solve.photons=2000",
                    "--output", place / "compare")
            etendue(program, "mesh", case, "-o", place / "mesh.vtu")
            etendue(program, "directions", case, "-o", place / "set.vtp")


def read_again(program, folder):
    """Has the program itself read what it wrote: a solution to start from, a mesh, results to draw."""
    for encoding in ENCODINGS:
        place = folder / encoding / "two-bands"
        case = place / "case.toml"
        etendue(program, "run", case, "--output", place / "again", "--set",
                f'solve.initial="{place / "by-ordinates" / "solution.vtu"}"')
        other = place / "from-mesh.toml"
        geometry = CASE[CASE.index("max_volume"):CASE.index("[media.air]")]
        other.write_text(case.read_text(encoding="utf-8").replace(geometry, 'file = "mesh.vtu"\n'), encoding="utf-8")
        etendue(program, "run", other, "--output", place / "from-mesh")
