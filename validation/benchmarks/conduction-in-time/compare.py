# SPDX-License-Identifier: AGPL-3.0-or-later
"""The temperature by finite volumes and steps of first order (suite.heated_slab), extrapolated in both."""

from suite import planck
from suite.heated_slab import Slab, extrapolated
from suite.row import Row

GASES = [(0.5, lambda kelvin: planck.radiance(kelvin, 1e-9, 3e-6)), (4.0, lambda kelvin: planck.radiance(kelvin, 3e-6, 1.0))]
COOLING = {"h": 200.0, "ambient": 300.0, "heat_flux": 5000.0}
SOURCE, CAPACITY, START = 30000.0, 1000.0, 700.0  # [W/m^3], [J/(m^3 K)], [K]
TIMES = (5.0, 10.0, 20.0)  # [s]
HEIGHTS = (0.1, 0.3, 0.5, 0.7, 0.9)  # [m]
PLATE = "wall zmax"


def compare(runs):
    wanted = exact()
    found = []
    for name, result in runs.items():
        computed = {(row["quantity"], row["name"], round(float(row["t"]), 9)): float(row["value"])
                    for row in result.table("steps.csv")}
        for key, reference in wanted.items():
            quantity, place, t = key
            found.append(Row(f"{quantity.replace('_', ' ')} of {place}, t {t:g}, {name}", computed[key], reference))
    return found


def exact():
    """Cells of second order and steps of first: the halves of each extrapolate."""
    steps = {cells: extrapolated(course(cells, 80), course(cells, 160), 2) for cells in (40, 80)}
    return extrapolated(steps[40], steps[80], 4)


def course(cells, steps):
    slab = Slab(GASES, lambda kelvin: 5 + 0.02 * kelvin, COOLING, SOURCE, cells)
    slab.kelvin[:cells] = START
    length = TIMES[-1] / steps
    found = {}
    for step in range(1, steps + 1):
        slab.solve(CAPACITY / length)
        for t in TIMES:
            if step == round(t / length):
                found |= values(slab, t)
    return found


def values(slab, t):
    found = {("temperature", f"probe axis {i}", t): slab.at(height) for i, height in enumerate(HEIGHTS)}
    return found | {("temperature", PLATE, t): slab.kelvin[-1], ("net_heat", PLATE, t): slab.radiated()[-1]}
