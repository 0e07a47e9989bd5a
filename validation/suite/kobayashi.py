# SPDX-License-Identifier: AGPL-3.0-or-later
"""Kobayashi's problems: fluence at the points of the benchmark's lines."""

from suite.result import place, read_reference
from suite.row import Row

ALONG = {"1A": "y", "1B": "x", "1C": "x", "2A": "y", "2B": "x", "3A": "y", "3B": "x", "3C": "x"}


def absorber(row):
    """Case i: a published value and its own integral beside it, which says how far it converged."""
    return float(row["phi_published"]), float(row["phi_published"]) * max(float(row["rel_conv"]), 1e-6)


def scattering(row):
    """Case ii: Monte Carlo and its standard deviation."""
    return float(row["phi_gmvp"]), float(row["phi_gmvp"]) * float(row["fsd_gmvp"])


CASES = {"i": ("kobayashi_i.csv", absorber), "ii": ("kobayashi_ii.csv", scattering)}

FINE = 30_000  # cells, from which on their own functions are compared at points


def compare(runs):
    """Names of runs are i or ii, and "along rays" or "on directions". Of case i along rays on fine cells also what the
    linear functions of the cells say at the points."""
    found = []
    for name, result in runs.items():
        case, way = name.split(", ")
        table, reference = CASES[case]
        known = {(row["line"], place(row)): row for row in read_reference(table)}
        for row in result.probes:
            if (row["probe"], place(row)) in known:
                value, uncertainty = reference(known[row["probe"], place(row)])
                found.append(Row(f"{name}: {row['probe']} {row['x']},{row['y']},{row['z']}", float(row["fluence"]), value,
                                 uncertainty, plot=f"line {row['probe']}", curve=name, x=float(row[ALONG[row["probe"]]]),
                                 run=name, probe=row["probe"], index=row["index"], band=row["band"]))
                if name == "i, along rays" and result.summary["cells"] > FINE:
                    found.append(Row(f"field of i: {row['probe']} {row['x']},{row['y']},{row['z']}", float(row["fluence_field"]),
                                     value, uncertainty))
    return found
