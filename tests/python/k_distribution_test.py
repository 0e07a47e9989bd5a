# SPDX-License-Identifier: AGPL-3.0-or-later
import io
import pathlib
import sys
import unittest

import numpy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "examples" / "python"))

import k_distribution as example

WAVENUMBER = numpy.linspace(100, 12000, 4000)
SPECTRUM = numpy.exp(3 * numpy.sin(WAVENUMBER / 7) + 2 * numpy.sin(WAVENUMBER / 900))  # many lines of all strengths
KELVIN = numpy.array([300.0, 1000.0, 1700.0])


def emissivity(points, kelvin, length):
    """Of a column [m atm] by the table, and by the spectrum itself."""
    k, weight = example.k_distribution(WAVENUMBER, [SPECTRUM], [1000.0], [kelvin], points)
    power = example.powers(WAVENUMBER, kelvin)
    return weight[0] @ -numpy.expm1(-k[0] * length), power[1:] @ -numpy.expm1(-SPECTRUM * length)


class KDistribution(unittest.TestCase):
    def test_emits_as_the_spectrum_does(self):
        for kelvin in (500.0, 1000.0, 1800.0):
            for length in (0.01, 0.1, 1.0, 10.0):
                for points, error in ((8, 0.04), (32, 0.005)):
                    table, spectrum = emissivity(points, kelvin, length)
                    self.assertLess(abs(table / spectrum - 1), error, (kelvin, length, points))

    def test_has_weights_that_add_up_to_one(self):
        _, weight = example.k_distribution(WAVENUMBER, [SPECTRUM], [1000.0], KELVIN)
        self.assertEqual(weight.shape, (3, 8))
        self.assertLess(abs(weight.sum(axis=1) - 1).max(), 1e-12)

    def test_follows_a_spectrum_that_scales_with_the_temperature(self):
        k, _ = example.k_distribution(WAVENUMBER, [SPECTRUM * 1000 / t for t in KELVIN], KELVIN, KELVIN)
        self.assertLess(abs(k * KELVIN[:, None] / (1000 * k[1]) - 1).max(), 1e-12)

    def test_writes_a_line_for_each_temperature_and_point(self):
        file = io.StringIO()
        example.write_table(KELVIN, *example.k_distribution(WAVENUMBER, [SPECTRUM], [1000.0], KELVIN, 4), file)
        lines = file.getvalue().splitlines()
        self.assertEqual(lines[0], "temperature,absorption,weight")
        self.assertEqual(len(lines), 13)


if __name__ == "__main__":
    unittest.main()
