# SPDX-License-Identifier: AGPL-3.0-or-later
"""Irradiance and open part of the half space at the bottom of wells; irradiance under lamps; walls, trenches and wedges without end."""

import re

from suite.result import last_digit, read_reference
from suite.row import Row


def compare(runs):
    return wells(runs) + endless(runs) + discs(runs) + rectangles(runs) + overhead(runs)


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
            found.append(Row(f"{name}, {kind[1]}: {word}", value, float(text), last_digit(text)))
    return found


# By case of the reference: the run and the place of its probe, of the numbers of the parameters.
ENDLESS = {
    "floor_point_near_infinite_wall": lambda height, distance: (f"wall {height}", (float(distance), 0, 0)),
    "infinite_trench_bottom_centre": lambda width, depth: (f"trench {depth}", (0, 0, 0)),
    "wedge_two_infinite_planes": lambda angle: (f"wedge {angle}", (1e-5, 0, 0)),
}


def endless(runs):
    found = []
    for row in read_reference("ambient_occlusion.csv"):
        if row["case"] not in ENDLESS:
            continue
        name, place = ENDLESS[row["case"]](*re.findall(r"\d+", row["parameters"]))
        point = runs[name].at(place)
        for word, value, text in (("irradiance", point["irradiance"], row["visibility_cosine"]),
                                  ("open part", point["fluence"] / 2, row["visibility_solid_angle"])):
            found.append(Row(f"{name}, x {place[0]:g}: {word}", value, float(text), last_digit(text)))
    return found


def discs(runs):
    found = []
    for row in read_reference("irradiance.csv"):
        numbers = re.fullmatch(r"R=([\d.]+) h=([\d.]+) lateral x=([\d.]+), L=1", row["parameters"])
        if not numbers:
            continue
        name = f"disc R {numbers[1]} h {numbers[2]}"
        point = runs[name].at((float(numbers[3]), 0, 0))
        found.append(Row(f"{name}, x {numbers[3]}", point["irradiance"], float(row["E"]), last_digit(row["E"])))
    return found


def rectangles(runs):
    found = []
    for row in read_reference("irradiance.csv"):
        numbers = re.fullmatch(r"size ([\dx]+) at height ([\d.]+) above .*", row["parameters"])
        if numbers:
            name = f"rectangle {numbers[1]} h {numbers[2]}"
            found.append(Row(name, runs[name].at((0, 0, 0))["irradiance"], float(row["E"]), last_digit(row["E"])))
    return found


def overhead(runs):
    """Discs on the axis of the receiver, and rectangles with a corner above it."""
    found = []
    for row in read_reference("irradiance.csv"):
        disc = re.fullmatch(r"half-angle (60|45|10|1) deg, L=1", row["parameters"])
        corner = re.fullmatch(r"size (\dx\d), corner above receiver, height 1, L=1", row["parameters"])
        if disc or corner:
            name = f"disc of half-angle {disc[1]}" if disc else f"corner of rectangle {corner[1]}"
            found.append(Row(name, runs[name].at((0, 0, 0))["irradiance"], float(row["E"]), last_digit(row["E"])))
    return found
