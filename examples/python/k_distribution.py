#!/usr/bin/python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A k-distribution of the full spectrum for bands.k_distribution, from the spectrum of a gas.

The spectrum is a CSV file with a line for each wave number: wavenumber [1/cm], then the absorption coefficient by the
partial pressure [1/(m atm)] at each temperature [K]; the first line names the columns: wavenumber,300,600,900. From a single
temperature the absorption is the same at all, as temperatures that follow from heat need it.

    examples/python/k_distribution.py spectrum.csv --points 8 > gas.csv

The absorption of a point is the quantile of the spectrum at the point's share of a blackbody's power at the reference
temperature; its weight at a temperature is the power of the blackbody in the wave numbers that belong to the point
(Modest and Zhang, J. Heat Transfer 124 (2002) 30). Power beyond the spectrum belongs to what does not absorb."""

import argparse
import sys

import numpy

SECOND_RADIATION_CONSTANT = 1.438776877  # [cm K]


def planck_density(wavenumber, kelvin):
    """Fraction of a blackbody's power by wave number [cm]."""
    x = SECOND_RADIATION_CONSTANT * wavenumber / kelvin
    return 15 / numpy.pi**4 * SECOND_RADIATION_CONSTANT / kelvin * x**3 / numpy.expm1(x)


def powers(wavenumber, kelvin):
    """Fractions of a blackbody's power: first that beyond the spectrum, then of each wave number. They add up to 1."""
    inside = planck_density(wavenumber, kelvin) * numpy.gradient(wavenumber)
    return numpy.concatenate([[max(0.0, 1 - inside.sum())], inside]) / max(1.0, inside.sum())


def shares(points):
    """Shares of the power, 0 to 1, at the points, and those between them: Gauss-Legendre points, squared towards the
    strong lines, which are few."""
    nodes, weights = numpy.polynomial.legendre.leggauss(points)
    x = (1 - nodes) / 2
    weights = weights * x
    weights /= weights.sum()
    return 1 - x**2, numpy.concatenate([[0], numpy.cumsum(weights[:-1]), [1]])


def k_distribution(wavenumber, absorption, kelvin, weights_at, points=8, reference=1000.0):
    """Absorption [temperature][point] and weight [temperature][point] at the temperatures `weights_at`.

    `absorption[i]` is the spectrum at the temperature `kelvin[i]`, which rises."""
    spectra = numpy.column_stack([numpy.zeros(len(kelvin)), absorption])
    at_reference = numpy.array([numpy.interp(reference, kelvin, column) for column in spectra.T])
    power = powers(wavenumber, reference)
    at, between = shares(points)

    def in_order(spectrum):
        order = numpy.argsort(spectrum, kind="stable")
        return order, numpy.cumsum(power[order])

    def quantiles(spectrum):
        order, share = in_order(spectrum)
        return spectrum[order][numpy.minimum(numpy.searchsorted(share, at), len(order) - 1)]

    order, share = in_order(at_reference)
    point = numpy.empty(len(order), dtype=int)
    point[order] = numpy.clip(numpy.searchsorted(between, share) - 1, 0, points - 1)
    found = numpy.array([quantiles(spectrum) for spectrum in spectra])
    k = numpy.array([[numpy.interp(t, kelvin, column) for column in found.T] for t in weights_at])
    weight = numpy.array([numpy.bincount(point, powers(wavenumber, t), points) for t in weights_at])
    return k, weight


def read_spectrum(path):
    """Wave numbers, absorption by temperature, temperatures: both rise. Raises ValueError where the file is no spectrum."""
    with open(path, encoding="utf-8") as file:
        names = file.readline().strip().split(",")[1:]
        table = numpy.loadtxt(file, delimiter=",", ndmin=2)
    kelvin = numpy.array([float(name) for name in names])
    if table.shape[1] != 1 + len(kelvin) or not len(kelvin):
        raise ValueError(f"the first line names {len(kelvin)} temperatures where the others have {table.shape[1] - 1} values")
    table = table[numpy.argsort(table[:, 0])][:, numpy.concatenate([[0], 1 + numpy.argsort(kelvin)])]
    table, kelvin = table[table[:, 0] != 0], numpy.sort(kelvin)
    if not numpy.isfinite(table).all() or (table < 0).any():
        raise ValueError("wave numbers and absorption have to be finite and not below 0")
    for what, values in (("wave number", table[:, 0]), ("temperature", kelvin)):
        if (numpy.diff(values) <= 0).any():
            raise ValueError(f"a {what} is there twice")
    if len(table) < 2 or kelvin[0] <= 0:
        raise ValueError("needs two wave numbers above 0 and temperatures above 0 K")
    return table[:, 0], table[:, 1:].T, kelvin


def write_table(weights_at, k, weight, file):
    file.write("temperature,absorption,weight\n")
    for t, *columns in zip(weights_at, k, weight):
        for values in zip(*columns):
            file.write(f"{t:g},{values[0]:.10g},{values[1]:.12g}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("spectrum", help="CSV file: wavenumber [1/cm], then absorption [1/(m atm)] at each temperature")
    parser.add_argument("--points", type=int, default=8, help="each becomes a band (default: 8)")
    parser.add_argument("--reference", type=float, default=1000.0, help="temperature of the reference [K] (default: 1000)")
    parser.add_argument("--to", type=float, default=2500.0, help="highest temperature of the table [K] (default: 2500)")
    given = parser.parse_args()
    if given.points < 1 or given.to < 300 or given.reference <= 0:
        parser.error("use at least one point, --to of at least 300 K, and a reference above 0 K")
    try:
        wavenumber, absorption, kelvin = read_spectrum(given.spectrum)
    except (OSError, ValueError) as error:
        parser.error(f"{given.spectrum}: {error}")
    weights_at = numpy.arange(300.0, given.to + 1, 100.0)
    write_table(weights_at, *k_distribution(wavenumber, absorption, kelvin, weights_at, given.points, given.reference), sys.stdout)


if __name__ == "__main__":
    main()
