# SPDX-License-Identifier: AGPL-3.0-or-later
import pathlib
import sys
import unittest

import numpy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "examples" / "python"))

import heat_loop


class HeatLoop(unittest.TestCase):
    def test_of_a_uniform_block_as_warm_as_its_walls_is_still(self):
        divergence = heat_loop.radiated(heat_loop.block(), numpy.full(heat_loop.CUBES, heat_loop.WALL))
        emitted = 4 * heat_loop.ABSORPTION * 5.670374419e-8 * heat_loop.WALL**4
        self.assertLess(abs(divergence).max(), 1e-4 * emitted)

    def test_warms_the_middle_and_is_symmetric(self):
        temperature, gain = heat_loop.run(20)
        self.assertGreater(temperature[2, 1, 1], 600)
        self.assertEqual(temperature.argmax() in (numpy.ravel_multi_index(at, heat_loop.CUBES) for at in ((2, 1, 1), (3, 1, 1))), True)
        self.assertLess(abs(temperature - temperature[::-1, ::-1, ::-1]).max(), 1e-2)
        self.assertLess(gain.sum(), 2 * heat_loop.SOURCE)


if __name__ == "__main__":
    unittest.main()
