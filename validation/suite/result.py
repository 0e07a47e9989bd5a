# SPDX-License-Identifier: AGPL-3.0-or-later
"""What a run wrote, as numbers, and tables of references."""

import csv
import functools
import json
import math
import pathlib

REFERENCES = pathlib.Path(__file__).resolve().parent.parent / "reference"


def read_rows(path):
    """Rows of a CSV file as dictionaries, without its '#' lines."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def read_reference(name):
    return read_rows(REFERENCES / name)


def read_origin(name):
    """The '#' lines above a table of references: what it is and where it comes from."""
    with open(REFERENCES / name, encoding="utf-8") as file:
        return " ".join(line[1:].strip() for line in file if line.startswith("#"))


def last_digit(text):
    """Half a unit of the last digit that a number was printed with: what its rounding leaves open."""
    mantissa, _, exponent = text.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 0.5 * 10.0 ** (int(exponent or 0) - decimals)


def same_point(a, b):
    return all(math.isclose(p, q, abs_tol=1e-9) for p, q in zip(a, b))


class Result:
    """The folder that a run wrote."""

    def __init__(self, name, folder, seconds=0.0):
        self.name = name
        self.folder = folder
        self.seconds = seconds

    @functools.cached_property
    def summary(self):
        return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))

    @functools.cached_property
    def probes(self):
        return read_rows(self.folder / "probes.csv")

    @property
    def history(self):
        """Rows of history.csv; none of a study, or where nothing was iterated."""
        path = self.folder / "history.csv"
        return read_rows(path) if path.is_file() else []

    @property
    def bands(self):
        return self.summary["bands"]

    @functools.cached_property
    def _walls(self):
        return {(row["wall"], row["band"]): row for row in read_rows(self.folder / "walls.csv")}

    @functools.cached_property
    def _regions(self):
        return {(row["region"], row["band"]): row for row in read_rows(self.folder / "regions.csv")}

    def wall(self, name, column, band=None):
        return float(self._walls[name, band or self.bands[0]][column])

    def walls(self):
        return list(dict.fromkeys(name for name, _ in self._walls))

    def region(self, name, column, band=None):
        return float(self._regions[name, band or self.bands[0]][column])

    def regions(self):
        return list(dict.fromkeys(name for name, _ in self._regions))

    @functools.cached_property
    def _heat(self):
        return {row["name"]: row for row in read_rows(self.folder / "heat.csv")}

    def heat(self, name, column):
        """Heat that a wall or region of a case with temperatures exchanges."""
        return float(self._heat[name][column])

    def probe(self, name, band=None):
        """Rows of a probe in the order of its points, their numbers as numbers."""
        band = band or self.bands[0]
        return [numbers(row) for row in self.probes if row["probe"] == name and row["band"] == band]

    def at(self, point, band=None, probe=None):
        """The row of the probe at a place."""
        band = band or self.bands[0]
        for row in self.probes:
            if row["band"] == band and probe in (None, row["probe"]) and same_point(place(row), point):
                return numbers(row)
        raise KeyError(f"{self.name}: no probe at {point}, band {band}")

    @functools.cached_property
    def _sensors(self):
        return {(row["sensor"], row["quantity"], row["band"]): float(row["value"]) for row in read_rows(self.folder / "sensors.csv")}

    def sensor(self, name, quantity, band=None):
        """What an instrument shows; band "photopic" is what the eye sees."""
        return self._sensors[name, quantity, band or self.bands[0]]

    def table(self, file):
        """Rows of any CSV file."""
        return read_rows(self.folder / file)

    @functools.cached_property
    def study(self):
        return json.loads((self.folder / "study.json").read_text(encoding="utf-8"))


def place(row):
    return tuple(float(row[axis]) for axis in "xyz")


def numbers(row):
    found = dict(row)
    for key, text in row.items():
        if key not in ("probe", "index", "band") and text:
            found[key] = float(text)
    return found
