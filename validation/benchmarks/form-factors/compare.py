# SPDX-License-Identifier: AGPL-3.0-or-later
"""Form factors between walls and of elements; lengths stand in the names of the runs."""

import re

from suite.result import read_reference, read_rows
from suite.row import Row


def factor(result, start, end):
    """From some walls to others: the mean over the area of the first."""
    rows = [row for row in read_rows(result.folder / "form_factors.csv") if row["from"] in start and row["to"] in end]
    sent = sum(result.wall(row["from"], "area") * float(row["factor"]) for row in rows)
    return sent / sum(result.wall(name, "area") for name in start)


def without(result, *names):
    return [name for name in result.walls() if name not in names]


def seen_by_element(result):
    return float(result.probes[0]["irradiance"])


# By configuration of the reference: how its parameters make the name of a run, and what is read there.
CONFIGURATIONS = {
    "parallel_rect_aligned": (lambda a, b, h: f"facing {a} {b} {h}", lambda run: factor(run, ["zmin"], ["lit"])),
    "perp_rect_common_edge": (lambda w, h, e: f"edge {w},{e},{h}", lambda run: factor(run, ["zmin"], ["lit"])),
    "parallel_rect_offset": (lambda x, y: f"offset {x} {y}", lambda run: factor(run, ["from"], ["lit"])),
    "element_parallel_rect_corner": (lambda a, b, h: f"element below {a},{b},{h}", seen_by_element),
    "element_perp_rect_corner": (lambda a, b, c: f"element beside {c},{b},{a}", seen_by_element),
    "infinite_parallel_strips": (lambda h, w: f"strips {h}", lambda run: factor(run, ["from"], ["lit"])),
    "infinite_perp_strips": (lambda w, h: f"upright strips {h}", lambda run: factor(run, ["from"], ["lit"])),
    "triangle_345_infinite": (lambda: "triangle", lambda run: factor(run, ["1"], ["2"])),
    "coaxial_discs": (lambda r, other, h: f"cylinder {h}" if r == other else f"discs {r}-{other}",
                      lambda run: factor(run, *((["zmin"], ["zmax"]) if "zmin" in run.walls() else (["1"], ["2"])))),
    "sphere_to_coaxial_disc": (lambda r, h: f"ball and disc {r} {h}", lambda run: factor(run, ["ball"], ["zmax"])),
    "coaxial_cylinders_infinite": (lambda outer, inner: f"cylinders {outer} {inner}", seen_by_element),
    "base->wall": (lambda r, h: f"cylinder {h}", lambda run: factor(run, ["zmin"], without(run, "zmin", "zmax"))),
    "wall->wall": (lambda r, h: f"cylinder {h}",
                   lambda run: factor(run, without(run, "zmin", "zmax"), without(run, "zmin", "zmax"))),
    "concentric_spheres": (lambda outer, inner: f"sphere in {outer}", lambda run: factor(run, without(run, "inner"), ["inner"])),
    "cube_face_to_inscribed_sphere": (lambda r: f"sphere {r} in a cube", lambda run: factor(run, ["xmin"], ["inner"])),
}


def lengths(parameters):
    """The numbers of a reference's parameters; of an offset where the second rectangle begins."""
    second = re.search(r"-> A2 x\((\d+), .* y\((\d+), ", parameters)
    return list(second.groups()) if second else re.findall(r"=(\d+\.?\d*)", parameters)


def compare(runs):
    found = []
    for row in read_reference("form_factors.csv"):
        configuration = row["configuration"]
        if configuration == "cylinder_inside":
            configuration = row["parameters"].split()[-1]
        if configuration not in CONFIGURATIONS:
            continue
        run_of, read = CONFIGURATIONS[configuration]
        run = run_of(*lengths(row["parameters"]))
        if run in runs:
            found.append(Row(f"{run}: {configuration}", read(runs[run]), float(row["F"])))
    return found
