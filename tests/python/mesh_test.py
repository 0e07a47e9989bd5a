# SPDX-License-Identifier: AGPL-3.0-or-later
import itertools
import pathlib
import tempfile
import types
import unittest

import etendue
import numpy

# The unit cube cut into six along its diagonal (Kuhn 1960).
POINTS = numpy.array(list(itertools.product((0, 1), repeat=3)), dtype=float)


def cells():
    for steps in itertools.permutations((4, 2, 1)):
        corners = [0, *itertools.accumulate(steps)]
        volume = numpy.linalg.det(POINTS[corners[1:]] - POINTS[corners[0]])
        yield corners if volume > 0 else [corners[1], corners[0], *corners[2:]]


def boundary(cells):
    faces = [tuple(sorted(face)) for cell in cells for face in itertools.combinations(cell, 3)]
    return [face for face in faces if faces.count(face) == 1]


CELLS = list(cells())
FLOOR = [face for face in boundary(CELLS) if all(POINTS[p, 2] == 0 for p in face)]
REST = [face for face in boundary(CELLS) if face not in FLOOR]


class Meshes(unittest.TestCase):
    def test_of_arrays(self):
        mesh = etendue.Mesh(POINTS, CELLS, region=["air"] * 5 + ["fog"], walls={"floor": FLOOR, "rest": REST})
        self.assertEqual((mesh.cell_count, mesh.point_count), (6, 8))
        self.assertEqual(set(mesh.region_names), {"air", "fog"})
        self.assertEqual(mesh.wall_names, ["floor", "rest"])
        self.assertEqual(mesh.points.shape, (8, 3))
        self.assertAlmostEqual(mesh.volumes.sum(), 1)
        self.assertEqual((numpy.asarray(mesh.region_names)[mesh.cell_regions] == "fog").sum(), 1)
        floor = mesh.boundary_faces[mesh.face_walls == 0]
        self.assertEqual(mesh.points[floor][:, :, 2].max(), 0)

    def test_without_walls_have_one(self):
        self.assertEqual(etendue.Mesh(POINTS, CELLS).wall_names, ["boundary"])

    def test_of_other_cells_know_these(self):
        hexahedra = """<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="12" NumberOfCells="2"><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1  0 0 3  1 0 3  1 1 3  0 1 3</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3 4 5 6 7  4 5 6 7 8 9 10 11</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">8 16</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">12 12</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>"""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "two.vtu"
            file.write_text(hexahedra, encoding="utf-8")
            mesh = etendue.read_mesh(file)
        volumes = numpy.bincount(mesh.parents, weights=mesh.volumes)
        numpy.testing.assert_allclose(volumes, [1, 2], rtol=1e-14)
        self.assertEqual(etendue.Mesh(POINTS, CELLS).parents.size, 0)

    def test_that_are_wrong_are_refused(self):
        with self.assertRaises(etendue.InputError):
            etendue.Mesh(POINTS, [[0, 1, 2, 9]])
        with self.assertRaises(etendue.InputError):
            etendue.Mesh(POINTS, CELLS, walls={"floor": FLOOR})

    def test_arrays_outlive_the_mesh_and_cannot_be_changed(self):
        points = etendue.Mesh(POINTS, CELLS).points
        self.assertEqual(sorted(map(tuple, points)), sorted(map(tuple, POINTS)))
        with self.assertRaises(ValueError):
            points[0, 0] = 5

    def test_of_meshio(self):
        block = lambda kind, data: types.SimpleNamespace(type=kind, data=numpy.array(data))
        found = types.SimpleNamespace(points=POINTS, cells=[block("triangle", FLOOR + REST), block("tetra", CELLS)],
                                      cell_sets={"floor": [numpy.arange(2), None], "rest": [numpy.arange(2, 12), None],
                                                 "fog": [None, numpy.array([5])]})
        mesh = etendue.from_meshio(found)
        self.assertEqual(set(mesh.region_names), {"medium", "fog"})
        self.assertEqual(mesh.wall_names, ["floor", "rest"])

    def test_are_written_and_read(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh, file = etendue.Mesh(POINTS, CELLS), pathlib.Path(folder) / "cube.vtu"
            mesh.write(file)
            self.assertTrue((etendue.read_mesh(file).points == mesh.points).all())
            self.assertAlmostEqual(etendue.read_mesh(file, 2).volumes.sum(), 8)

    def test_are_solved_on(self):
        mesh = etendue.Mesh(POINTS, CELLS, walls={"floor": FLOOR, "rest": REST})
        case = {"media": {"medium": {"absorption": 1}}, "walls": {"floor": {"radiance": 1}, "rest": {}},
                "directions": {"set": "product", "order": 2}}
        solution = etendue.solve(case, mesh=mesh)
        self.assertTrue(solution.converged)
        self.assertEqual(solution.fluence.shape, (6, 4, 1))
        sent = {row["wall"]: row["outgoing"] for row in solution.walls}
        self.assertEqual((sent["floor"], sent["rest"]), (solution.balance[0]["inflow"], 0))
        self.assertGreater(sent["floor"], 3)


if __name__ == "__main__":
    unittest.main()
