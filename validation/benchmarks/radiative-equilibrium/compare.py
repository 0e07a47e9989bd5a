# SPDX-License-Identifier: AGPL-3.0-or-later
"""Heat fluxes, fluences and temperatures, against the integral equation of the slab."""

import numpy

from suite.result import last_digit, read_reference
from suite.row import Line, Row

PLOT = "fluence by height"
SIGMA = 5.670374419e-8
HEIGHTS = (0.0, 0.25, 0.5, 0.75, 1.0)
# mu = t^2 is smooth where rays graze.
T, WEIGHT = (0.5 * (v + shift) for v, shift in zip(numpy.polynomial.legendre.leggauss(200), (1, 0)))
MU, WEIGHT = T ** 2, 2 * T * WEIGHT


def expint(n, x):
    """Exponential integral E_n for n >= 2: the integral of mu^(n-2) e^(-x/mu)."""
    return numpy.exp(-numpy.multiply.outer(x, 1 / MU)) @ (WEIGHT * MU ** (n - 2))


class Slab:
    """G/4 = (J_0 E2(t) + J_1 E2(T - t) + integral of s E1(|t - t'|))/2 with s = G/4 + Q/(4 beta) and radiosities J, in
    cells of constant s: collocation in the middle of each, whose error falls with the square of their width.
    `plates`: (temperature, emissivity), the temperature None of an adiabatic one."""

    def __init__(self, kappa, scattering, heat, plates, cells):
        beta = kappa + scattering
        self.kappa, self.beta, self.heat, self.plates = kappa, beta, heat, plates
        edges = 0.5 * (1 - numpy.cos(numpy.pi * numpy.arange(cells + 1) / cells)) * beta
        self.edges, self.z = edges, (edges[1:] + edges[:-1]) / 2 / beta
        own = heat(self.z) / (4 * beta)
        kernel = self.kernel(self.z * beta)
        ends = self.from_plates(self.z * beta)
        # Irradiance of the plates: twice the integral of s E2, and the other plate.
        arrives = numpy.array([expint(3, edges[:-1]) - expint(3, edges[1:]),
                               expint(3, beta - edges[1:]) - expint(3, beta - edges[:-1])]) * 2
        through = 2 * expint(3, numpy.array([beta]))[0]
        # Unknowns: G/4 in cells, then J of the plates.
        n = cells
        matrix, right = numpy.zeros((n + 2, n + 2)), numpy.zeros(n + 2)
        matrix[:n, :n] = numpy.eye(n) - kernel
        matrix[:n, n:] = -ends
        right[:n] = kernel @ own
        for plate, (kelvin, emissivity) in enumerate(plates):
            row = n + plate
            reflects = 1.0 if kelvin is None else 1 - emissivity
            matrix[row, row] = 1
            matrix[row, :n] -= reflects * arrives[plate]
            matrix[row, n + 1 - plate] -= reflects * through
            right[row] = reflects * arrives[plate] @ own + (0 if kelvin is None else emissivity * SIGMA * kelvin ** 4)
        solved = numpy.linalg.solve(matrix, right)
        self.quarter, self.sent = solved[:n], solved[n:]
        self.source = self.quarter + own
        self.incident = [arrives[p] @ self.source + through * self.sent[1 - p] for p in (0, 1)]

    def kernel(self, depth):
        """Half the integrals of E1(|t - t'|) over the cells, at depths."""
        at = numpy.subtract.outer(depth, self.edges)
        # The integral of E1 from 0 to x is 1 - E2(x), odd in x.
        primitive = numpy.sign(at) * (1 - expint(2, numpy.abs(at)))
        return (primitive[:, :-1] - primitive[:, 1:]) / 2

    def from_plates(self, depth):
        return numpy.stack([expint(2, depth), expint(2, self.beta - depth)], axis=1) / 2

    def fluence(self, z):
        depth = numpy.array([z * self.beta])
        return 4 * (self.kernel(depth) @ self.source + self.from_plates(depth) @ self.sent)[0]

    def mean_temperature(self):
        widths = numpy.diff(self.edges) / self.beta
        return widths @ ((self.quarter + self.heat(self.z) / (4 * self.kappa)) / SIGMA) ** 0.25

    def values(self):
        found = {f"heat flux into z{end}": self.incident[p] - self.sent[p] for p, end in ((0, "min"), (1, "max"))}
        found |= {f"fluence at {z:g} m": self.fluence(z) for z in HEIGHTS}
        found["mean temperature of the gas"] = self.mean_temperature()
        found["temperature of zmax"] = (self.plates[1][0] if self.plates[1][0] is not None
                                        else (self.incident[1] / SIGMA) ** 0.25)
        return found


def extrapolated(*slab):
    """Values of a slab, and what the last refinement changed in them."""
    coarse, fine = (Slab(*slab, cells).values() for cells in (100, 200))
    return {name: (fine[name] + (fine[name] - coarse[name]) / 3, abs(fine[name] - coarse[name]) / 10) for name in fine}


EXACT = {
    "plates": extrapolated(2.0, 0.0, lambda z: 0 * z, [(1000.0, 1.0), (500.0, 1.0)]),
    "heated": extrapolated(2.0, 1.0, lambda z: 4e4 * z, [(600.0, 0.7), (None, 0.8)]),
}


def measured(result):
    found = {f"heat flux into z{end}": result.heat(f"z{end}", "density") for end in ("min", "max")}
    found |= {f"fluence at {z:g} m": result.at((0.5, 0.5, z))["fluence"] for z in HEIGHTS}
    found["mean temperature of the gas"] = result.heat("gas", "temperature")
    found["temperature of zmax"] = result.heat("zmax", "temperature")
    return found


def compare(runs):
    found = []
    table = {row["tau"]: row["Q"] for row in read_reference("heaslet_warming.csv")}
    plates = SIGMA * (1000.0 ** 4 - 500.0 ** 4)
    found.append(Row("plates: heat flux by the table", runs["plates"].heat("zmax", "density"), float(table["2.0"]) * plates,
                     last_digit(table["2.0"]) * plates))
    for run, result in runs.items():
        exact = EXACT["plates" if run == "plates" else "heated"]
        for name, value in measured(result).items():
            height = float(name.split()[2]) if name.startswith("fluence") else None
            reference, uncertainty = exact[name]
            found.append(Row(f"{run}: {name}", value, reference, uncertainty, plot=PLOT if height is not None else "",
                             curve=run, x=height))
    return found


def lines(runs):
    return [Line(PLOT, run, [p["z"] for p in points], [p["fluence"] for p in points])
            for run, result in runs.items() for points in [result.probe("height")]]
