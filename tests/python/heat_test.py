# SPDX-License-Identifier: AGPL-3.0-or-later
import tomllib
import unittest

import etendue

import small

PLATE = {
    "mesh": {"max_volume": 0.02, "box": [{"region": "air", "min": [0, 0, 0], "max": [1, 1, 1]}]},
    "media": {"air": {}},
    "walls": {"*": {"specular": 1}, "zmin": {"temperature": 1000},
              "zmax": {"emissivity": 0.5, "convection": {"h": 20, "ambient": 300}}},
    "directions": {"set": "product", "order": 4},
    "solve": {"tolerance": 1e-10},
}


class Heat(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.solution = etendue.solve(PLATE)
        cls.rows = {row["name"]: row for row in cls.solution.heat}

    def test_of_a_plate_is_carried_away(self):
        plate = self.rows["zmax"]
        self.assertGreater(plate["convected"], 1000)
        self.assertAlmostEqual(plate["net"] / plate["convected"], 1, delta=1e-8)
        self.assertAlmostEqual(plate["convected"] / (20 * (plate["temperature"] - 300)), 1, delta=1e-9)

    def test_temperatures_have_their_shapes(self):
        mesh = self.solution.mesh
        self.assertEqual(self.solution.cell_temperature.shape, (mesh.cell_count,))
        self.assertEqual(self.solution.wall_temperature.shape, (len(mesh.boundary_faces), 3))
        walls = [mesh.wall_names[wall] for wall in mesh.face_walls]
        for name, kelvin in zip(walls, self.solution.wall_temperature):
            expected = {"zmin": 1000, "zmax": self.rows["zmax"]["temperature"]}.get(name, 0)
            for value in kelvin:
                self.assertAlmostEqual(value, expected, delta=1e-3)

    def test_is_empty_without_temperatures(self):
        solution = etendue.solve(tomllib.loads(small.TEXT))
        self.assertEqual(solution.heat, [])
        self.assertEqual(solution.cell_temperature.size, 0)
        self.assertEqual(solution.wall_temperature.size, 0)
