# SPDX-License-Identifier: AGPL-3.0-or-later
import tomllib
import unittest

import numpy
from etendue import toml

import small


class Toml(unittest.TestCase):
    def test_reads_back_what_it_writes(self):
        tree = {"title": 'say "é"\n\x7f\\', "a b": 1, "x": {"list": [1, 2.5, [True, "t"]], "inline": [{"k": 1}, 3], "deep": {"empty": {}}},
                "rows": [{"n": 1, "inner": [{"q": 1e-300}, {"q": float("inf")}]}, {"n": 2}]}
        self.assertEqual(tomllib.loads(toml.dumps(tree)), tree)

    def test_reads_back_a_case(self):
        tree = tomllib.loads(small.TEXT)
        self.assertEqual(tomllib.loads(toml.dumps(tree)), tree)

    def test_takes_numbers_of_numpy(self):
        text = toml.dumps({"a": numpy.float64(0.1), "b": numpy.arange(3), "c": numpy.bool_(True), "t": (1, 2)})
        self.assertEqual(tomllib.loads(text), {"a": 0.1, "b": [0, 1, 2], "c": True, "t": [1, 2]})

    def test_refuses_what_toml_has_not(self):
        for value in (None, 1j, {1: 2}, object()):
            with self.assertRaises(TypeError):
                toml.dumps({"key": value})


if __name__ == "__main__":
    unittest.main()
