# SPDX-License-Identifier: AGPL-3.0-or-later
"""Irradiance and open part of the half space at the bottom of wells, before walls without end, under a ball; irradiance under lamps and skies."""

import re

from suite.result import read_reference
from suite.row import Row

DIGITS = 5e-13  # of the references: closed forms with 12 decimals, of which trailing zeros are left out


def compare(runs):
    return wells(runs) + open_parts(runs) + discs(runs) + rectangles(runs) + overhead(runs) + balls(runs) + others(runs)


def wells(runs):
    found = []
    for row in read_reference("ambient_occlusion.csv"):
        kind = re.fullmatch(r"box_well_bottom_(centre|corner)", row["case"])
        if not kind:
            continue
        name = f"box well {row['parameters'].split('depth=')[1]}"
        place = {"centre": (0.5, 0.5, 0), "corner": (0, 0, 0)}[kind[1]]
        point = runs[name].at(place)
        for word, value, text in (("irradiance", point["irradiance"], row["visibility_cosine"]),
                                  ("open part", point["fluence"] / 2, row["visibility_solid_angle"])):
            found.append(Row(f"{name}, {kind[1]}: {word}", value, float(text), DIGITS))
    return found


# By case of the reference: the run and the place of its probe, of the numbers of the parameters. The ball that touches the floor has no run.
OPEN_PARTS = {
    "cylinder_well_bottom_centre": lambda radius, depth: (f"round well {radius} {depth}", (0, 0, 0)),
    "sphere_above_plane_point_below": lambda radius, height: (f"ball above {height}", (0, 0, 0)),
    "floor_point_near_infinite_wall": lambda height, distance: (f"wall {height}", (float(distance), 0, 0)),
    "infinite_trench_bottom_centre": lambda width, depth: (f"trench {depth}", (0, 0, 0)),
    "wedge_two_infinite_planes": lambda angle: (f"wedge {angle}", (1e-5, 0, 0)),
}


def open_parts(runs):
    found = []
    for row in read_reference("ambient_occlusion.csv"):
        name, place = OPEN_PARTS.get(row["case"], lambda *_: ("", ()))(*re.findall(r"\d+", row["parameters"]))
        if name not in runs:
            continue
        point = runs[name].at(place)
        for word, value, text in (("irradiance", point["irradiance"], row["visibility_cosine"]),
                                  ("open part", point["fluence"] / 2, row["visibility_solid_angle"])):
            found.append(Row(f"{name}, x {place[0]:g}: {word}", value, float(text), DIGITS))
    return found


def discs(runs):
    found = []
    for row in read_reference("irradiance.csv"):
        numbers = re.fullmatch(r"R=([\d.]+) h=([\d.]+) lateral x=([\d.]+), L=1", row["parameters"])
        if not numbers:
            continue
        name = f"disc R {numbers[1]} h {numbers[2]}"
        point = runs[name].at((float(numbers[3]), 0, 0))
        found.append(Row(f"{name}, x {numbers[3]}", point["irradiance"], float(row["E"]), DIGITS))
    return found


def rectangles(runs):
    found = []
    for row in read_reference("irradiance.csv"):
        numbers = re.fullmatch(r"size ([\dx]+) at height ([\d.]+) above .*", row["parameters"])
        if numbers:
            name = f"rectangle {numbers[1]} h {numbers[2]}"
            found.append(Row(name, runs[name].at((0, 0, 0))["irradiance"], float(row["E"]), DIGITS))
    return found


def overhead(runs):
    """Discs on the axis of the receiver, and rectangles with a corner above it."""
    found = []
    for row in read_reference("irradiance.csv"):
        disc = re.fullmatch(r"half-angle (60|45|10|1) deg, L=1", row["parameters"])
        corner = re.fullmatch(r"size (\dx\d), corner above receiver, height 1, L=1", row["parameters"])
        if disc or corner:
            name = f"disc of half-angle {disc[1]}" if disc else f"corner of rectangle {corner[1]}"
            found.append(Row(name, runs[name].at((0, 0, 0))["irradiance"], float(row["E"]), DIGITS))
    return found


def balls(runs):
    found = []
    for row in read_reference("irradiance.csv"):
        numbers = re.fullmatch(r"radius ([\d.]+), centre distance (\d), L=1", row["parameters"])
        if numbers:
            name = f"ball of radius {numbers[1]}"
            point = runs[name].at((0, 0, float(numbers[2])))
            found.append(Row(f"{name}, {numbers[2]} away", point["irradiance"], float(row["E"]), DIGITS))
    return found


def irradiance_of(probe):
    return lambda run, *numbers: run.probe(probe.format(*numbers))[0]["irradiance"]


def reading_of(sensor):
    return lambda run, *numbers: run.sensor(sensor.format(*numbers), "irradiance")


# By case of the reference: a pattern of its parameters, runs, and what is read there.
OTHERS = {
    "disc_on_axis": (r"half-angle 90 deg, L=1", ["open sky"], reading_of("tilted 0")),
    "point_source": (r"I=1 W/sr at distance 2, incidence (\d+) deg", ["point"], irradiance_of("incidence {}")),
    "hemisphere_tilted_receiver": (r".* tilted (\d+) deg", ["open sky"], reading_of("tilted {}")),
    "lambert_polygon": (r".*", ["triangle"], irradiance_of("point")),
    "cos_sky_moon_spencer": (r".*", ["sky of Moon and Spencer", "walls of Moon and Spencer"], reading_of("floor")),
}


def others(runs):
    found = []
    for row in read_reference("irradiance.csv"):
        pattern, names, read = OTHERS.get(row["case"], ("", [], None))
        numbers = re.fullmatch(pattern, row["parameters"])
        for name in names if numbers else []:
            label = ", ".join([name, *({"disc_on_axis": ["half-angle 90"]}.get(row["case"]) or numbers.groups())])
            found.append(Row(label, read(runs[name], *numbers.groups()), float(row["E"]), DIGITS))
    return found
