# SPDX-License-Identifier: AGPL-3.0-or-later
"""Values by photons beside their references; the uncertainty is that of both together."""

import math

from suite.kobayashi import CASES
from suite.result import last_digit, place, read_reference, same_point
from suite.row import Row


def slab_rows(result, g, tau):
    known = {float(row["w"]): row for row in read_reference("slab_diffuse.csv")
             if (float(row["g"]), float(row["tau"])) == (g, tau)}
    for band in (band for band in result.bands if float(band) in known):
        sent = result.wall("lit", "outgoing", band)
        for part, wall, column in (("R", "lit", "R"), ("T", "dark", "T_total")):
            reference = known[float(band)]
            yield Row(f"{part}, slab g {g:g}, tau {tau:g}, albedo {band}", result.wall(wall, "incoming", band) / sent,
                      float(reference[column]),
                      math.hypot(result.wall(wall, "incoming_error", band) / sent, float(reference["conv"])))


def half_space_row(result):
    reference, = read_reference("mcml_half_space.csv")
    surface = ((1.5 - 1) / (1.5 + 1)) ** 2
    balance, error = result.summary["balance"][0], result.summary["photons"]["balance_error"][0]
    scale = (1 - surface) / balance["inflow"]
    return Row("total reflectance of a half-space of index 1.5", surface + scale * balance["outflow"], float(reference["published"]),
               math.hypot(scale * error["outflow"], last_digit(reference["published"])))


def pencil_row(result, index):
    reference, = (row for row in read_reference("pencil_cube.csv") if float(row["index"]) == index)
    return Row(f"absorbed share of a pencil beam, index {index:g}", result.summary["balance"][0]["absorbed"], float(reference["absorbed"]),
               math.hypot(result.summary["photons"]["balance_error"][0]["absorbed"], float(reference["sd"])))


def cube_references():
    """(band, quantity, point, value, standard deviation)"""
    for row in read_reference("cube_hot_medium_wall_flux.csv"):
        if row["x"] != "avg":
            yield f"{float(row['kappa']):g} 0 0", "q", (float(row["x"]), float(row["y"]), 0.0), float(row["q"]), 5e-10
    for row in read_reference("cube_scattering_hot_medium.csv"):
        band = f"{row['beta']} {row['w']} {row['g']}"
        yield band, row["quantity"], place(row), float(row["value"]), float(row["sd"])


def cube_rows(result):
    for band, quantity, point, value, deviation in cube_references():
        for row in (row for row in result.probes if row["band"] == band and same_point(place(row), point)):
            column, scale = ("irradiance", 1) if quantity == "q" else ("fluence", 0.25)
            if row[column]:
                yield Row(f"{quantity} at {point}, medium {band}", scale * float(row[column]), value,
                          math.hypot(scale * float(row[column + "_error"]), deviation))


def kobayashi_rows(result, case):
    table, reference = CASES[case]
    known = {(row["line"], place(row)): row for row in read_reference(table)}
    for row in result.probes:
        if (row["probe"], place(row)) in known:
            value, uncertainty = reference(known[row["probe"], place(row)])
            yield Row(f"kobayashi {case}: {row['probe']} {row['x']},{row['y']},{row['z']}", float(row["fluence"]), value,
                      math.hypot(uncertainty, float(row["fluence_error"])))


# Columns are 1/64 km wide and stand for themselves and their mirror images.
def cloud_rows(result):
    known = {int(row["column"]): row for row in read_reference("i3rc_step_cloud.csv") if row["experiment"] == "1"}
    image = {c: 15 - c if c < 16 else 47 - c for c in range(8, 24)}
    for c in range(8, 24):
        for part, wall in (("R", f"top {c}"), ("T", f"bottom {c}")):
            both = [float(known[k][part]) for k in (c, image[c])]
            # What the images differ by is the noise of the consensus.
            spread = max(abs(both[0] - both[1]) / 2, 0.0015 / math.sqrt(2))
            yield Row(f"{part}, step cloud, column {c}", result.wall(wall, "irradiance_mean"), sum(both) / 2,
                      math.hypot(result.wall(wall, "irradiance_mean_error"), spread),
                      plot="step cloud, sun in the zenith", curve=part, x=c)


def compare(runs):
    found = []
    for name, result in runs.items():
        if name.startswith("slab"):
            g, tau = (float(word.split()[-1]) for word in name.split(", "))
            found += slab_rows(result, g, tau)
        elif name.startswith("kobayashi"):
            found += kobayashi_rows(result, name.split()[-1])
        elif name.startswith("pencil"):
            found.append(pencil_row(result, float(name.split()[-1])))
        elif name == "half-space":
            found.append(half_space_row(result))
        else:
            found += cube_rows(result) if name == "cube" else cloud_rows(result)
    return found
