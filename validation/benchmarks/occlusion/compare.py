# SPDX-License-Identifier: AGPL-3.0-or-later
"""Irradiance and open part of the half space at the bottom of wells; irradiance under lamps."""

import re

from suite.result import last_digit, read_reference
from suite.row import Row


def compare(runs):
    return wells(runs) + discs(runs) + rectangles(runs)


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
