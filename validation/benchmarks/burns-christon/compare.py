# SPDX-License-Identifier: AGPL-3.0-or-later
"""div q along the middle line and flux on the wall."""

from suite.result import last_digit, read_reference
from suite.row import Row


def compare(runs):
    cube = runs["case"]
    found = []
    for row in read_reference("burns_christon_divq.csv"):
        x = float(row["x"])
        kappa = 0.9 * (1 - 2 * x) + 0.1
        found.append(Row(f"div q at {x:g}", kappa * (4 - cube.at((x, 0, 0), probe="axis")["fluence"]), float(row["divq"]),
                         last_digit(row["divq"]), plot="div q along the middle line", curve="div q", x=x))
    for row in read_reference("burns_christon_wall.csv"):
        y = float(row["y"])
        found.append(Row(f"wall at y = {y:g}", cube.at((0.5, y, 0), probe="wall")["irradiance"], float(row["q"]),
                         last_digit(row["q"]), plot="flux on the wall", curve="flux", x=y))
    return found
