# SPDX-License-Identifier: AGPL-3.0-or-later
"""The runs of a scene by the methods that are compared, and those that tell the errors of ordinates and radiosity."""

import dataclasses
import math
import subprocess
import time

from suite.result import Result

LIMIT = 1800  # [s], of one run


@dataclasses.dataclass
class Solved:
    """Results by the name of the run, and the faults of runs that failed, did not converge or do not balance."""

    results: dict
    faults: list
    seconds: float = 0.0


# Another set with about as many directions, closed under the same mirrors.
OTHER_DIRECTIONS = ("thurgood", 7)
# Photons read coefficients by formula as means of cells, an error of second order: a sixteenth of it is left.
PHOTON_SPLIT = 2
PATH_RAYS = 1024  # the default of the program, which the run "radiosity" takes
# Allowed residual of the energy balance: of ordinates that of rays to lamps, of photons that of their roulette.
BALANCE = {"ordinates": 5e-3, "photons": 5e-3, "radiosity": 1e-4}


def solve(scene, folder, options, photon_case=""):
    """Writes the case and runs it by all methods; `photon_case` is a text that photons get instead of it."""
    folder.mkdir(parents=True, exist_ok=True)
    case = folder / "case.toml"
    case.write_text(scene.text, encoding="utf-8")
    for name, text in scene.files.items():
        (folder / name).write_text(text, encoding="utf-8")
    if photon_case:
        (folder / "planted.toml").write_text(photon_case, encoding="utf-8")
    solved, started = Solved({}, []), time.monotonic()
    for name, overrides in runs_of(scene, options).items():
        _run(folder / "planted.toml" if photon_case and name == "photons" else case, name, overrides, options, solved)
    solved.seconds = time.monotonic() - started
    return solved


def runs_of(scene, options):
    """Overrides of the case for each run."""
    coarse = f"mesh.max_volume={8 * scene.case['mesh']['max_volume']:.6g}"
    name, order = OTHER_DIRECTIONS
    photons = ['solve.method="photons"', f"solve.photons={options.photons:g}", f"solve.probe_photons={options.photons / 10:g}",
               f"solve.seed={scene.seed + 1}"]
    if scene.coefficients_by_place:
        photons.append(f"mesh.refine={PHOTON_SPLIT}")
    found = {"ordinates": [], "directions": [f'directions.set="{name}"', f"directions.order={order}"], "mesh": [coarse],
             "photons": photons}
    if scene.body_volumes:
        found["bodies"] = [_fine_bodies(scene)]
    if scene.radiosity:
        by_radiosity = 'solve.method="radiosity"'
        found |= {"radiosity": [by_radiosity], "patches": [by_radiosity, coarse],
                  "rays": [by_radiosity, f"radiosity.path_rays={PATH_RAYS // 4}"]}
    return found


def _fine_bodies(scene):
    """The override for finer cells in bodies: their facets make cells there that no larger volume makes coarser."""
    room = scene.case["mesh"]["max_volume"]
    volumes = {name: min(room / 8, volume) for name, volume in scene.body_volumes.items()} | {'"*"': room}
    return "mesh.max_volume={" + ", ".join(f"{name} = {volume:.4g}" for name, volume in volumes.items()) + "}"


def _run(case, name, overrides, options, solved):
    folder = case.parent / name
    command = [str(options.program), "run", str(case), "--no-estimate", "--output", str(folder), "--progress", "none"]
    for override in [*overrides, *options.set]:
        command += ["--set", override]
    started = time.monotonic()
    try:
        done = subprocess.run(command, check=False, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        solved.faults.append(f"{name}: no end after {LIMIT} s")
        return
    if done.returncode not in (0, 1) or not (folder / "summary.json").is_file():
        lines = (done.stderr or done.stdout).strip().splitlines() or [""]
        solved.faults.append(f"{name}: exit code {done.returncode}: {lines[-1]}")
        return
    result = Result(name, folder, time.monotonic() - started)
    solved.results[name] = result
    solved.faults += _faults_of(result)


def _faults_of(result):
    found = [] if result.summary["converged"] else [f"{result.name}: not converged"]
    limit = BALANCE.get(result.name, math.inf)  # of runs that only estimate errors any
    for band, balance in zip(result.bands, result.summary["balance"]):
        if not abs(balance["residual"]) <= limit:
            found.append(f"{result.name}: balance of band {band}: residual {balance['residual']:.2e}, allowed {limit:g}")
    return found
