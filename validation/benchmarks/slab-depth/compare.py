# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence and net flux at nine depths of seven slabs."""

from suite.result import last_digit, read_reference
from suite.row import Row


def compare(runs):
    found = []
    for row in read_reference("slab_depth.csv"):
        name = f"w {row['w']}, tau {float(row['tau']):g}, g {row['g']}, {light(row)}"
        depth = float(row["frac"])
        point = runs[name].at((0.5, 0.5, depth))
        uncertainty = max(float(row["conv"]), 5e-8)
        found.append(Row(f"fluence, {name}, depth {depth:g} tau", point["fluence"], float(row["phi"]), uncertainty,
                         plot="fluence by depth", curve=name, x=depth))
        found.append(Row(f"net flux, {name}, depth {depth:g} tau", point["flux_z"], float(row["net"]), uncertainty))
    return found + of_the_mcml_paper(runs["w 0.9, tau 2, g 0.75, mu 1.0"])


def of_the_mcml_paper(slab):
    """Reflected and transmitted parts; the beam brings a power of 1."""
    area = slab.wall("zmin", "area")
    return [Row(f"MCML paper: {row['quantity']}", slab.wall("zmin" if row["quantity"] == "R" else "zmax", "incoming") / area,
                float(row["published"]), last_digit(row["published"])) for row in read_reference("mcml_paper.csv")]


def light(row):
    return "diffuse" if row["kind"] == "diffuse" else f"mu {row['mu0']}"
