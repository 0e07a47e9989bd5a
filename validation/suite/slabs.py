# SPDX-License-Identifier: AGPL-3.0-or-later
"""Slabs between walls "lit" and "dark": reflected and transmitted parts of the incident light."""

from suite.result import read_reference
from suite.row import Row


def parts(result, band, lit="lit", dark="dark"):
    """R and T."""
    sent = result.wall(lit, "outgoing", band)
    return {"R": result.wall(lit, "incoming", band) / sent, "T": result.wall(dark, "incoming", band) / sent}


def compare_parts(result, table, wanted, key, plot):
    """Rows of a table of references that are `wanted`; their column `key` is the number that names the band."""
    bands = {float(band): band for band in result.bands}
    found = []
    for row in read_reference(table):
        band = bands.get(float(row[key]))
        if band is None or not wanted(row):
            continue
        for name, column in (("R", "R"), ("T", "T_total")):
            found.append(Row(f"{name}, {key} = {band}", parts(result, band)[name], float(row[column]),
                             uncertainty=max(float(row["conv"]), 5e-10), plot=plot, curve=name, x=float(band)))
    return found


def compare_thicknesses(runs, table):
    """Runs named "g G, tau T" of cases whose bands are albedos."""
    known = {(float(row["g"]), float(row["tau"]), float(row["w"])): row for row in read_reference(table)}
    found = []
    for name, result in runs.items():
        g, tau = (float(word.split()[1]) for word in name.split(", "))
        for band in result.bands:
            if (g, tau, float(band)) in known:
                found += part_rows(f"{name}, albedo {band}", parts(result, band, *lit_and_dark(result)), known[g, tau, float(band)])
    return found


def lit_and_dark(result):
    """The walls' names; on a column those of its ends."""
    return ("lit", "dark") if "lit" in result.walls() else ("zmin", "zmax")


SMALL = 0.01  # of the incident light: what is below is compared as a part of it, the rest relatively


def part_rows(label, computed, row):
    found = []
    for part, column, word in (("R", "R", "reflected"), ("T", "T_total", "transmitted")):
        size = ", small" if float(row[column]) < SMALL else ""
        found.append(Row(f"{part}, {label}{size}", computed[part], float(row[column]), uncertainty=max(float(row["conv"]), 5e-10),
                         plot=f"{word} part, optical thickness {float(row['tau']):g}", curve=f"g = {float(row['g']):g}",
                         x=float(row["w"])))
    return found
