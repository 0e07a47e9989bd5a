# SPDX-License-Identifier: AGPL-3.0-or-later
import gc
import os
import pathlib
import subprocess
import tempfile
import tomllib
import unittest

import etendue
import numpy

import small


class Fields(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.solution = etendue.solve(tomllib.loads(small.TEXT))

    def test_have_their_shapes(self):
        cells, faces = self.solution.mesh.cell_count, len(self.solution.mesh.boundary_faces)
        self.assertEqual(self.solution.fluence.shape, (cells, 4, 2))
        self.assertEqual(self.solution.net_flux.shape, (cells, 4, 3, 2))
        self.assertEqual(self.solution.irradiance.shape, (faces, 3, 2))
        self.assertEqual(self.solution.exitance.shape, (faces, 3, 2))

    def test_are_shown_not_copied(self):
        first, second = self.solution.fluence, self.solution.fluence
        self.assertEqual(first.ctypes.data, second.ctypes.data)
        self.assertFalse(first.flags.owndata)
        with self.assertRaises(ValueError):
            first[0, 0, 0] = 1

    def test_keep_the_solution_alive(self):
        solution = etendue.solve(tomllib.loads(small.TEXT))
        field, kept = solution.fluence, solution.fluence.copy()
        del solution
        gc.collect()
        numpy.zeros(field.size * 4)  # would reuse the memory
        self.assertTrue((field == kept).all())

    def test_have_the_bits_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "room.toml"
            case.write_text(small.TEXT, encoding="utf-8")
            subprocess.run([os.environ["ETENDUE"], "run", case, "--output", pathlib.Path(folder) / "command", "--no-estimate"],
                           check=True, capture_output=True)
            etendue.solve(etendue.load(case)).write(pathlib.Path(folder) / "module")
            for name in ("walls.csv", "regions.csv", "probes.csv"):
                one, other = ((pathlib.Path(folder) / by / name).read_bytes() for by in ("command", "module"))
                self.assertEqual(one, other, name)

    def test_totals_are_those_of_the_fields(self):
        mesh, solution = self.solution.mesh, self.solution
        volumes = mesh.volumes
        for row in solution.regions:
            chosen = mesh.cell_regions == mesh.region_names.index(row["region"])
            mean = (volumes[chosen] @ solution.fluence[chosen].mean(axis=1)[:, solution.bands.index(row["band"])]) / volumes[chosen].sum()
            self.assertAlmostEqual(row["fluence_mean"] / mean, 1, places=9)

    def test_at_points(self):
        inside, outside = self.solution.fluence_at([[1, 0.5, 0.6], [9, 9, 9]])
        self.assertTrue((inside > 0).all())
        self.assertTrue(numpy.isnan(outside).all())
        with self.assertRaises(ValueError):
            self.solution.fluence_at([[1, 2]])

    def test_at_the_points_of_probes(self):
        row = self.solution.probes[0]
        value = self.solution.fluence_at([row["x"], row["y"], row["z"]])[0, self.solution.bands.index(row["band"])]
        self.assertEqual(value, row["fluence"])

    def test_balance(self):
        for band in self.solution.balance:
            self.assertLess(abs(band["residual"]), 1e-3)  # light along rays is in balance to that
            self.assertGreater(band["inflow"], 0)

    def test_tables_and_texts(self):
        self.assertIn("converged", repr(self.solution))
        self.assertIn("<table>", self.solution._repr_html_())
        with self.assertRaises(ValueError):
            self.solution.to_pandas("rooms")


class Pictures(unittest.TestCase):
    def test_are_arrays_and_files(self):
        tree = tomllib.loads(small.TEXT)
        tree["camera"] = [{"name": "view", "position": [0.1, 0.1, 0.5], "look_at": [1.5, 0.8, 0.5], "pixels": [12, 8]}]
        solution = etendue.solve(tree)
        picture = solution.render("view")
        self.assertEqual((picture.radiance.shape, picture.srgb.shape), ((8, 12, 2), (8, 12, 3)))
        self.assertGreater(picture.radiance.max(), 0)
        self.assertTrue(picture.png().startswith(b"\x89PNG"))
        self.assertIn("<img", solution._repr_html_())
        with self.assertRaises(etendue.InputError):
            solution.render("none")


if __name__ == "__main__":
    unittest.main()
