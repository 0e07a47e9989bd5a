# SPDX-License-Identifier: AGPL-3.0-or-later
"""Illuminance of 1 W/m^2, and the colour of a picture of one pixel."""

from suite.exr import read_pixel
from suite.result import last_digit, read_reference
from suite.row import Row

SOURCES = {"blackbody_K": "black body", "equal_energy_380_780": "equal energy", "monochromatic_nm": "monochromatic"}


def compare(runs):
    found = []
    for row in read_reference("luminous_efficacy.csv"):
        name = SOURCES[row["source"]] + (f" {row['parameter']}" if row["parameter"] != "-" else "")
        run = runs["lines" if row["source"] == "monochromatic_nm" else "spectra"]
        known = row["K_visible_lm_per_W"]
        found.append(Row(f"{name}: efficacy", run.sensor(name, "illuminance", "photopic"), float(known), last_digit(known)))
        for axis, value in zip("xy", chromaticity(read_pixel(run.folder / f"{name}.exr"))):
            found.append(Row(f"{name}: {axis}", value, float(row[axis]), last_digit(row[axis])))
    return found


def chromaticity(pixel):
    """x and y of linear sRGB."""
    matrix = [row for row in read_reference("srgb_matrices.csv") if row["matrix"] == "RGB_to_XYZ"]
    tristimulus = [sum(float(row[f"c{k}"]) * pixel[channel] for k, channel in enumerate("RGB")) for row in matrix]
    return [value / sum(tristimulus) for value in tristimulus[:2]]
