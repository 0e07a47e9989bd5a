// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/tetrahedralize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue {
namespace {

std::string message_of(const SurfaceComplex& surface, const TetrahedraOptions& options = {}) {
  try {
    tetrahedralize(surface, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

double region_volume(const TetrahedralMesh& mesh, const std::string& name) {
  double volume = 0;
  for (int c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region_names()[static_cast<std::size_t>(mesh.region(CellIndex(c)))] == name)
      volume += mesh.volume(CellIndex(c));
  return volume;
}

TEST(Tetrahedralize, FillsTheCubeExactly) {
  const TetrahedralMesh mesh = cube_mesh(2.25e-4);
  EXPECT_NEAR(mesh.cell_count(), 11700, 600);
  EXPECT_NEAR(region_volume(mesh, "domain"), 1, 1e-12);
  EXPECT_LE(*std::max_element(mesh.volumes().begin(), mesh.volumes().end()), 2.25e-4);
  std::vector<double> areas(mesh.wall_names().size(), 0);
  for (int f = 0; f < mesh.boundary_face_count(); ++f)
    areas[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] += mesh.area(FaceIndex(f));
  ASSERT_EQ(mesh.wall_names(), (std::vector<std::string>{"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"}));
  for (const double area : areas) EXPECT_NEAR(area, 1, 1e-12);
}

}  // namespace
}  // namespace etendue
