#!/usr/bin/python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The spectrum of a gas that does not exist: six bands of random lines, which become weaker as 1/T. Run in validation/,
`python3 -m suite.line_spectrum 300 1000 > spectrum.csv` writes it at temperatures [K] for examples/python/k_distribution.py."""

import sys

import numpy

WAVENUMBER = numpy.linspace(200.0, 8000.0, 6000)  # [1/cm]
HALF_WIDTH = 1.5  # of a line [1/cm]
REFERENCE = 1000.0  # [K]
# Middle and width of a band [1/cm], mean strength of its lines [1/(m atm)], and how many they are.
BANDS = ((1600, 250, 90, 200), (2350, 80, 180, 60), (3700, 300, 75, 220), (667, 80, 120, 60), (5300, 250, 9, 120), (400, 200, 60, 60))


def at_reference():
    """Absorption coefficient by the partial pressure at each wave number [1/(m atm)], at 1,000 K."""
    random = numpy.random.RandomState(1)  # its numbers are the same in all versions
    k = numpy.zeros_like(WAVENUMBER)
    for middle, width, strength, lines in BANDS:
        for line, peak in zip(random.normal(middle, width, lines), random.exponential(strength, lines)):
            k += peak * HALF_WIDTH ** 2 / ((WAVENUMBER - line) ** 2 + HALF_WIDTH ** 2)
    return k


def main():
    temperatures = [float(text) for text in sys.argv[1:]]
    print("wavenumber," + ",".join(f"{t:g}" for t in temperatures))
    k = at_reference()
    for wavenumber, value in zip(WAVENUMBER, k):
        print(f"{wavenumber:.10g}," + ",".join(f"{value * REFERENCE / t:.8g}" for t in temperatures))


if __name__ == "__main__":
    main()
