# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reflected and transmitted part of the incident light."""

import math

from suite.result import last_digit, read_reference
from suite.row import Row
from suite.slabs import lit_and_dark, parts

HISTORIES = 2e7


def compare(runs):
    found = []
    for row in read_reference("slab_monte_carlo.csv"):
        name = f"w {row['w']}, tau {row['tau']}, g {row['g']}, mu0 {row['mu0']}"
        computed = parts(runs[name], runs[name].bands[0], *lit_and_dark(runs[name]))
        transmitted = float(row["T_mc"])
        found.append(Row(f"R, {name}", computed["R"], float(row["R_mc"]), float(row["sd_R"])))
        found.append(Row(f"T, {name}", computed["T"], transmitted, math.sqrt(transmitted * (1 - transmitted) / HISTORIES)))
    for row in read_reference("slab_doubling.csv"):
        name = f"w {row['w']}, tau {row['tau']}, g {row['g']}, mu0 {row['mu0']}"
        if name in runs:
            computed = parts(runs[name], runs[name].bands[0], *lit_and_dark(runs[name]))
            found += [Row(f"{part}, {name}", computed[part], float(row[part]), last_digit(row[part])) for part in "RT"]
    return found
