# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence along the line, means of the slabs, light both ways in the void, absorption beyond z = 5."""

from suite.result import last_digit, read_reference
from suite.row import Line, Row

PLOT = "fluence along the line"
MEANS = {"average phi region 5-6": ("shining",), "average phi region 0-2": ("source",),
         "average phi region 2-3": ("absorber",), "average phi region 3-5": ("void",)}
CURRENTS = {"leftward current (half-range) at x=5": "downward", "rightward current (half-range) at x=5": "upward"}


def compare(runs):
    return [row for name, result in runs.items() for row in compare_run(result, "" if name == "case" else f"{name}: ")]


def compare_run(reed, prefix):
    """Rows of a run; the plot shows those of the one that is in both sets."""
    plot = "" if prefix else PLOT
    found = [Row(f"{prefix}fluence at {row['x']}", reed.at((5, 5, float(row["x"])))["fluence"], float(row["phi"]),
                 max(float(row["conv"]), last_digit(row["phi"])), plot=plot, curve="fluence", x=float(row["x"]))
             for row in read_reference("reed_fluence.csv")]
    exact = {row["quantity"]: row["value"] for row in read_reference("reed_integrals.csv")}
    for name, regions in MEANS.items():
        volume = sum(reed.region(region, "volume") for region in regions)
        mean = sum(reed.region(region, "fluence_mean") * reed.region(region, "volume") for region in regions) / volume
        label = prefix + name.replace("average phi region", "mean fluence")
        found.append(Row(label, mean, float(exact[name]), last_digit(exact[name])))
    for name, probe in CURRENTS.items():
        value = reed.probe(probe)[0]["irradiance"]
        found.append(Row(f"{prefix}light {probe} in the void", value, float(exact[name]), last_digit(exact[name])))
    absorbed = sum(reed.region(region, "absorbed") for region in ("shining", "scattering")) / 20 ** 2
    text = exact["absorption in 5<x<8 per unit area"]
    found.append(Row(f"{prefix}absorption in 5 < z < 8", absorbed, float(text), last_digit(text)))
    return found


def lines(runs):
    points = runs["case"].probe("line")
    return [Line(PLOT, "fluence", [p["z"] for p in points], [p["fluence"] for p in points])]
