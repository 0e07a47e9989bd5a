# SPDX-License-Identifier: AGPL-3.0-or-later
"""The part of the incident light that comes back; bands are albedos, runs are inclinations."""

from suite.result import last_digit, read_reference
from suite.row import Row


def compare(runs):
    found = [row_of(runs[f"mu {row['mu']}"], row["w"], row["plane_albedo"]) for row in read_reference("chandrasekhar_h.csv")
             if f"mu {row['mu']}" in runs and row["w"] in runs[f"mu {row['mu']}"].bands]
    return found + [row_of(runs["diffuse"], row["w"], row["diffuse_albedo"]) for row in read_reference("diffuse_albedo.csv")
                    if row["w"] in runs["diffuse"].bands]


def row_of(result, band, text):
    part = result.wall("zmin", "incoming", band) / result.wall("zmin", "outgoing", band)
    return Row(f"{result.name}, w {band}", part, float(text), last_digit(text), plot="part that comes back", curve=result.name,
               x=float(band))
