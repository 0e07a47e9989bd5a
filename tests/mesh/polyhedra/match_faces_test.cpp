// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/polyhedra/match_faces.h"

#include <gtest/gtest.h>

#include <array>

#include "base/errors.h"
#include "tests/mesh/polyhedra/sample_polyhedra.h"

namespace etendue::match_faces_test {
namespace {

/// Two triangular prisms side by side over a unit square, each face in any direction.
struct TwoPrisms {
  PolyhedralMesh mesh;
  Polygons of_cells, of_walls;

  TwoPrisms() {
    mesh.file = "two.vtu";
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    mesh.cell_regions = {0, 0};
    mesh.wall_names = {"floor"};
    add_prism(0, {0, 1, 2});
    add_prism(1, {2, 3, 0});
  }
  void add_prism(int cell, const std::array<int, 3>& base) {
    const auto& [a, b, c] = base;
    of_cells.add(cell, base);
    of_cells.add(cell, std::array{a + 4, b + 4, c + 4});
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      of_cells.add(cell, std::array{p, q, q + 4, p + 4});
  }
  std::string fault() {
    try {
      match_faces(of_cells, of_walls, mesh);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }
};

TEST(MatchFaces, JoinsCellsAndTurnsFacesOutward) {
  TwoPrisms two;
  two.of_walls.add(0, std::array{2, 1, 0});
  ASSERT_EQ(two.fault(), "none");
  ASSERT_EQ(two.mesh.face_count(), 9U);
  int within = 0, named = 0;
  for (std::size_t f = 0; f < 9; ++f) {
    if (two.mesh.neighbors[f] >= 0) {
      ++within;
      EXPECT_EQ(two.mesh.owners[f], 0);
      EXPECT_EQ(two.mesh.neighbors[f], 1);
    }
    if (two.mesh.face_walls[f] == 0) ++named;
  }
  EXPECT_EQ(within, 1);
  EXPECT_EQ(named, 1);
  // The floor of the first: seen from below.
  EXPECT_EQ(std::vector<int>(two.mesh.face(0).begin(), two.mesh.face(0).end()), (std::vector<int>{2, 1, 0}));
}

TEST(MatchFaces, RefusesAFaceOfThreeCells) {
  TwoPrisms two;
  two.mesh.cell_regions.push_back(0);
  two.add_prism(2, {2, 3, 0});
  EXPECT_EQ(two.fault(), "two.vtu: face of points 0 2 4 6: belongs to cells 0, 1 and 2; cells overlap");
}

TEST(MatchFaces, RefusesAWallThatIsNoFace) {
  TwoPrisms two;
  two.of_walls.add(0, std::array{0, 1, 6});
  EXPECT_EQ(
      two.fault(),
      "two.vtu: polygon of points 0 1 6 of wall \"floor\" is no face of a cell; walls must be faces of the "
      "mesh");
}

}  // namespace
}  // namespace etendue::match_faces_test
