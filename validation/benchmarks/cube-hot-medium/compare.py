# SPDX-License-Identifier: AGPL-3.0-or-later
"""Flux on a wall and fluence along the axis; bands are absorption coefficients kappa."""

from suite.result import last_digit, place, read_reference, same_point
from suite.row import Line, Row

LINE, AXIS = "flux along the middle line of a wall", "fluence along the axis"


def compare(runs):
    return [row for cube in runs.values() for band in cube.bands for row in [*on_walls(cube, band), *on_axis(cube, band)]]


def label(cube, text):
    return f"{cube.name}: {text}" if cube.name == "along rays" else text


def curve(cube, band):
    return label(cube, f"kappa {band}")


def on_walls(cube, band):
    found = []
    for row in read_reference("cube_hot_medium_wall_flux.csv"):
        if float(row["kappa"]) != float(band):
            continue
        exact = {"reference": float(row["q"]), "uncertainty": last_digit(row["q"])}
        if row["x"] == "avg":
            means = [cube.wall(wall, "irradiance_mean", band) for wall in cube.walls()]
            found.append(Row(label(cube, f"wall mean, kappa {band}"), sum(means) / len(means), **exact))
            continue
        x, y = float(row["x"]), float(row["y"])
        for p in at(cube, (x, y, 0), band, ("wall", "wall-diagonal", "wall-edge")):
            line = {"plot": LINE, "curve": curve(cube, band), "x": x} if y == 0.5 else {}
            found.append(Row(label(cube, f"wall {x:g},{y:g}, kappa {band}"), p["irradiance"], **exact, **line, run=cube.name,
                             probe=p["probe"], index=p["index"], band=band, column="irradiance"))
    return found


def on_axis(cube, band):
    found = []
    for row in read_reference("cube_hot_medium_axis.csv"):
        z = float(row["z"])
        if float(row["kappa"]) != float(band):
            continue
        for p in at(cube, (0.5, 0.5, z), band, ("axis",)):
            found.append(Row(label(cube, f"axis {z:g}, kappa {band}"), p["fluence"], 4 * float(row["G_over_4E"]),
                             uncertainty=4 * last_digit(row["G_over_4E"]), plot=AXIS, curve=curve(cube, band), x=z, run=cube.name,
                             probe="axis", index=p["index"], band=band))
    return found


def at(cube, point, band, probes):
    return [row for name in probes for row in cube.probe(name, band) if same_point(place(row), point)]


def lines(runs):
    cube = runs["case"]
    found = []
    for band in cube.bands:
        wall, axis = cube.probe("wall", band), cube.probe("axis", band)
        found.append(Line(LINE, f"kappa {band}", [p["x"] for p in wall], [p["irradiance"] for p in wall]))
        found.append(Line(AXIS, f"kappa {band}", [p["z"] for p in axis], [p["fluence"] for p in axis]))
    return found
