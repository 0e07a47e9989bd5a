# SPDX-License-Identifier: AGPL-3.0-or-later
"""Values of two methods side by side, each difference in units of the errors of both."""

import csv
import dataclasses
import math
import statistics

from suite.result import read_rows

TABLES = {"walls": ("wall", ("incoming",)), "regions": ("region", ("absorbed", "fluence_mean")),
          "probes": ("probe", ("fluence", "irradiance"))}
FLOOR = 1e-3       # of the mean of the quantity over the scene: smaller errors are not asked for
WIDE = 0.03        # of a value: a bar beyond this judges little
# An error that falls with the power 3/2 of the size of cells, as where radiance has kinks, is this part of the change
# on cells twice as large, or half as large.
ON_LARGER, ON_SMALLER = 1 / (2 ** 1.5 - 1), 1 / (1 - 2 ** -1.5)
# With a quarter of the rays, drawn anew, the variance of the change is 1 + 4 times that of the value.
OF_CHANGE = {"mesh": ON_LARGER, "bodies": ON_SMALLER, "patches": ON_LARGER, "directions": 1.0, "rays": 1 / math.sqrt(5)}
# The runs whose changes tell the errors of mesh and directions, by method.
CHANGED = {"ordinates": (("mesh", "bodies"), ("directions",)), "radiosity": (("patches",), ("rays",))}
# Of the normal distribution: the median of |x| is this part of its standard deviation.
MEDIAN_OF_NORMAL = 0.6745


@dataclasses.dataclass
class Compared:
    """One value by two methods; `noise`, `mesh` and `directions` are its errors [unit of the value]."""

    seed: int
    method: str
    where: str
    quantity: str
    band: str
    first: float
    second: float
    noise: float
    mesh: float
    directions: float  # of radiosity that of its rays
    floor: float

    @property
    def bar(self):
        return math.hypot(self.noise, self.mesh, self.directions, self.floor)

    @property
    def units(self):
        """The difference over its bar; infinite where a value is not a number."""
        difference = self.second - self.first
        if difference == 0:
            return 0.0
        units = difference / self.bar if self.bar > 0 else math.inf
        return units if math.isfinite(units) else math.inf

    @property
    def wide(self):
        return self.bar > WIDE * max(abs(self.first), abs(self.second))


def entries_of(result, tables):
    """(kind of place, where, quantity, row, (value, standard error)) of what is there of the columns of some tables of a run."""
    for table, (name, quantities) in tables.items():
        path = result.folder / f"{table}.csv"
        for row in read_rows(path) if path.is_file() else []:
            where = f"{name} {row[name]}" + (f" {row['index']}" if "index" in row else "")
            for quantity in quantities:
                if row.get(quantity):
                    yield name, where, quantity, row, (float(row[quantity]), float(row.get(f"{quantity}_error") or 0))


def values_of(result):
    """Value and standard error of everything that is compared, by (where, quantity, band)."""
    # On a wall the linear functions of the cells give fluence to first order only: irradiance is compared there.
    return {(where, quantity, row["band"]): value for _, where, quantity, row, value in entries_of(result, TABLES)
            if not (quantity == "fluence" and row["irradiance"])}


def compare(scene, method, results):
    """All values of `method` beside those of photons. `results` are those of the runs by name."""
    other = [name for names in CHANGED[method] for name in names if name != "bodies" or scene.body_volumes]
    if not {method, "photons", *other} <= results.keys():
        return []
    first, second = values_of(results[method]), values_of(results["photons"])
    changes = {name: errors_from(first, values_of(results[name]), OF_CHANGE[name]) for name in other}
    floors = floors_of(first)
    found = []
    for key, (value, _) in first.items():
        if key not in second:
            continue
        where, quantity, band = key
        errors = [math.hypot(*(changes[name].get(key, 0.0) for name in names if name in changes)) for names in CHANGED[method]]
        found.append(Compared(scene.seed, method, where, quantity, band, value, *second[key], *errors, floors[quantity, band]))
    return found


def missing(method, results):
    """Values of `method` that photons do not have, as faults."""
    if not {method, "photons"} <= results.keys():
        return []
    known = values_of(results["photons"])
    return [f"photons: no {quantity} of {where}, {band}, which {method} have"
            for where, quantity, band in values_of(results[method]) if (where, quantity, band) not in known]


def floors_of(values):
    """By quantity and band, FLOOR of the mean over all places."""
    groups = {}
    for (_, quantity, band), (value, _) in values.items():
        groups.setdefault((quantity, band), []).append(abs(value))
    return {key: FLOOR * statistics.fmean(group) for key, group in groups.items()}


def errors_from(first, second, part):
    """Errors estimated as `part` of the differences of two runs.

    One difference may vanish by chance, so its square is averaged with that of the typical relative difference of the same
    quantity in the scene (the moderated variance of Smyth 2004)."""
    changes = {key: second[key][0] - value for key, (value, _) in first.items() if key in second}
    relative = {}
    for key, change in changes.items():
        if first[key][0]:
            relative.setdefault(key[1], []).append(abs(change / first[key][0]))
    typical = {quantity: statistics.median(group) / MEDIAN_OF_NORMAL for quantity, group in relative.items()}
    return {key: part * math.sqrt(0.5 * (change ** 2 + (typical.get(key[1], 0.0) * first[key][0]) ** 2))
            for key, change in changes.items()}


COLUMNS = ("seed", "method", "where", "quantity", "band", "first", "second", "noise", "mesh", "directions", "floor", "bar",
           "units")


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file)
        out.writerow(COLUMNS)
        for row in rows:
            entries = [getattr(row, name) for name in COLUMNS]
            out.writerow([f"{value:.6g}" if isinstance(value, float) else value for value in entries])
