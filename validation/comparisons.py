# SPDX-License-Identifier: AGPL-3.0-or-later
"""What a result says beside what its reference says: one function for each kind of reference."""

import csv
import dataclasses
import json
import math
import pathlib

import flatland

REFERENCES = pathlib.Path(__file__).resolve().parent / "reference"


@dataclasses.dataclass
class Comparison:
    """A computed value and its reference. `probe`, `index` and `band` say where, as in probes.csv."""

    label: str
    value: float
    reference: float
    probe: str = ""
    index: str = ""
    band: str = ""
    column: str = "fluence"

    @property
    def error(self):
        return self.value / self.reference - 1 if self.reference else self.value


def read_table(path):
    """Rows of a CSV file as dictionaries, without its '#' lines."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def read_summary(results):
    return json.loads((results / "summary.json").read_text(encoding="utf-8"))


def probe_rows(results):
    return {(row["probe"], int(row["index"]), row["band"]): row
            for row in read_table(results / "probes.csv")}


def of_probe(row, label, reference, column="fluence"):
    return Comparison(label, float(row[column]), reference, row["probe"], row["index"], row["band"], column)


def same_point(a, b):
    return all(math.isclose(p, q, abs_tol=1e-9) for p, q in zip(a, b))


def point(row):
    return tuple(float(row[axis]) for axis in "xyz")


def kobayashi(results, table, column):
    """Fluence at the points of the benchmark's lines."""
    known = {(row["line"], point(row)): float(row[column]) for row in read_table(REFERENCES / table)}
    found = []
    for row in probe_rows(results).values():
        reference = known.get((row["probe"], point(row)))
        if reference is not None:
            found.append(of_probe(row, f"{row['probe']} {row['x']},{row['y']},{row['z']}", reference))
    return found


def kobayashi_i(results):
    return kobayashi(results, "kobayashi_i.csv", "phi_published")


def kobayashi_ii(results):
    return kobayashi(results, "kobayashi_ii.csv", "phi_gmvp")


def absorbing_cube(results):
    """Flux on a wall (mean, along its middle line, near a corner) and fluence along the axis; bands are kappa."""
    walls = [row for row in read_table(results / "walls.csv")]
    found = []
    for row in read_table(REFERENCES / "cube_hot_medium_wall_flux.csv"):
        kappa, exact = float(row["kappa"]), float(row["q"])
        if row["x"] == "avg":
            means = [float(w["irradiance_mean"]) for w in walls if float(w["band"]) == kappa]
            found.append(Comparison(f"wall mean, kappa {kappa:g}", sum(means) / len(means), exact))
            continue
        place = (float(row["x"]), float(row["y"]), 0.0)
        found += [of_probe(p, f"wall {place[0]:g},{place[1]:g}, kappa {kappa:g}", exact, "irradiance")
                  for p in probe_rows(results).values()
                  if p["probe"] != "axis" and float(p["band"]) == kappa and same_point(point(p), place)]
    for row in read_table(REFERENCES / "cube_hot_medium_axis.csv"):
        kappa, place = float(row["kappa"]), (0.5, 0.5, float(row["z"]))
        found += [of_probe(p, f"axis {place[2]:g}, kappa {kappa:g}", 4 * float(row["G_over_4E"]))
                  for p in probe_rows(results).values()
                  if p["probe"] == "axis" and float(p["band"]) == kappa and same_point(point(p), place)]
    return found


def slab(results):
    """Reflected and transmitted part of the light that comes in; bands are albedos, tau = 2, g = 0.5."""
    walls = {(row["wall"], float(row["band"])): row for row in read_table(results / "walls.csv")}
    found = []
    for row in read_table(REFERENCES / "slab_diffuse.csv"):
        albedo = float(row["w"])
        if (float(row["g"]), float(row["tau"])) != (0.5, 2.0) or ("lit", albedo) not in walls:
            continue
        sent = float(walls["lit", albedo]["outgoing"])
        for name, wall, column in (("R", "lit", "R"), ("T", "dark", "T_total")):
            part = float(walls[wall, albedo]["incoming"]) / sent
            found.append(Comparison(f"{name}, albedo {albedo:g}", part, float(row[column])))
    return found


def haze(results):
    """Reflected and transmitted part of the light that comes in; bands are g, tau = 10, albedo 0.99."""
    walls = {(row["wall"], float(row["band"])): row for row in read_table(results / "walls.csv")}
    found = []
    for row in read_table(REFERENCES / "slab_diffuse.csv"):
        g = float(row["g"])
        if (float(row["w"]), float(row["tau"])) != (0.99, 10.0) or ("lit", g) not in walls:
            continue
        sent = float(walls["lit", g]["outgoing"])
        for name, wall, column in (("R", "lit", "R"), ("T", "dark", "T_total")):
            found.append(Comparison(f"{name}, g = {g:g}", float(walls[wall, g]["incoming"]) / sent, float(row[column])))
    return found


def canopy(results):
    """Reflectance and transmittance of level Lambertian leaves, whose upward and downward irradiance obey
    dE_down/dL = -(1 - t) E_down + r E_up and the same upwards (Goudriaan 1977); leaf area 2, dark ground."""
    walls = {(row["wall"], row["band"]): row for row in read_table(results / "walls.csv")}
    found = []
    for band, r, t in (("black", 0.0, 0.0), ("red", 0.08, 0.04), ("infrared", 0.45, 0.45)):
        rate = math.sqrt((1 - t) ** 2 - r ** 2)
        deep = (1 - t - rate) / r if r else 0.0
        through = math.exp(-2 * rate)
        exact = {"sky": deep * (1 - through ** 2) / (1 - (deep * through) ** 2),
                 "ground": (1 - deep ** 2) * through / (1 - (deep * through) ** 2)}
        sent = float(walls["sky", band]["outgoing"])
        for wall, name in (("sky", "R"), ("ground", "T")):
            if exact[wall]:
                found.append(Comparison(f"{name}, {band}", float(walls[wall, band]["incoming"]) / sent, exact[wall]))
    return found


def flatland_room(results):
    """Irradiance and fluence that a lamp of radiance 1 brings in the plane, through absorption, past a pillar: integrals
    over the angles in which the lamp is seen."""
    found = []
    for band, absorption in (("clear", 0.0), ("mist", 1.0)):
        light = flatland.Lamp(absorption)
        for row in read_table(results / "walls.csv"):
            if row["band"] == band and row["wall"] in flatland.WALLS:
                exact = light.mean_irradiance(*flatland.WALLS[row["wall"]])
                if exact:
                    found.append(Comparison(f"{row['wall']}, {band}", float(row["irradiance_mean"]), exact))
        for row in probe_rows(results).values():
            if row["band"] != band:
                continue
            place = point(row)[:2]
            label = f"{row['probe']} {place[0]:.2f}, {band}"
            if row["probe"] == "middle":
                found.append(of_probe(row, label, light.fluence(place)))
            else:
                found.append(of_probe(row, label, light.irradiance(place, (0, -1)), "irradiance"))
    return found


def furnace(results):
    """Fluence 4 pi L in every node of the field, at the probes, and irradiance pi L on every wall."""
    radiance = {"one": 1.0, "two": 2.0, "five": 5.0}
    found = [of_probe(row, f"{row['probe']} {row['index']}, L {row['band']}", 4 * math.pi * radiance[row["band"]])
             for row in probe_rows(results).values()]
    for band, (smallest, largest) in field_range(results, "fluence").items():
        exact = 4 * math.pi * radiance[band]
        found.append(Comparison(f"smallest fluence, L {band}", smallest, exact))
        found.append(Comparison(f"largest fluence, L {band}", largest, exact))
    return found


def smoke_room(results):
    """Mean irradiance of the walls and mean fluence of the regions, as a finer mesh with more directions has them."""
    known = {(row["table"], row["name"], row["band"]): float(row["value"])
             for row in read_table(REFERENCES / "smoke_room.csv")}
    found = []
    for table, key, column in (("walls", "wall", "irradiance_mean"), ("regions", "region", "fluence_mean")):
        for row in read_table(results / f"{table}.csv"):
            reference = known[table, row[key], row["band"]]
            found.append(Comparison(f"{row[key]}, {row['band']}", float(row[column]), reference, column=column))
    return found


def field_range(results, array):
    """Smallest and largest value of each component of a point array of fields.vtu."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(results / "fields.vtu"))
    reader.Update()
    data = reader.GetOutput().GetPointData().GetArray(array)
    values = vtk_to_numpy(data).reshape(data.GetNumberOfTuples(), -1)
    return {band: (values[:, k].min(), values[:, k].max()) for k, band in enumerate(read_summary(results)["bands"])}
