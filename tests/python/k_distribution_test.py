# SPDX-License-Identifier: AGPL-3.0-or-later
import io
import pathlib
import sys
import tempfile
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


class Spectrum(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "spectrum.csv"
            path.write_text(text, encoding="utf-8")
            return example.read_spectrum(path)

    def test_is_put_in_order(self):
        wavenumber, absorption, kelvin = self.read("wavenumber,1500,300\n30,5,6\n10,1,2\n20,3,4\n")
        self.assertEqual(list(wavenumber), [10, 20, 30])
        self.assertEqual(list(kelvin), [300, 1500])
        self.assertEqual(absorption.tolist(), [[2, 4, 6], [1, 3, 5]])

    def test_has_no_wave_number_of_zero(self):
        self.assertEqual(list(self.read("wavenumber,300\n0,1\n10,1\n20,3\n")[0]), [10, 20])

    def test_is_refused_where_it_is_none(self):
        for text in ("wavenumber,300\n10,nan\n20,1\n", "wavenumber,300\n10,-1\n20,1\n", "wavenumber,300\n10,1\n10,2\n",
                     "wavenumber,300,300\n10,1,1\n20,2,2\n", "wavenumber,300\n10,1,2\n20,1,2\n", "wavenumber,300\n10,1\n",
                     "wavenumber,a\n10,1\n20,1\n", "wavenumber\n10\n20\n"):
            with self.assertRaises(ValueError, msg=text):
                self.read(text)


if __name__ == "__main__":
    unittest.main()
