// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/raw_mesh_bytes.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::raw_mesh_bytes_test {
namespace {

std::string bytes_of(const RawMesh& mesh) {
  std::FILE* file = std::tmpfile();
  write_raw_mesh(file, mesh);
  std::string bytes(static_cast<std::size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  std::fclose(file);
  return bytes;
}

TEST(RawMeshBytes, ComeBackAsTheyWere) {
  RawMesh mesh = kuhn_cube_raw();
  mesh.cell_numbers = {1, 2, 3, 4, 5, 60000000000};
  const RawMesh again = take_raw_mesh(bytes_of(mesh));
  EXPECT_EQ(again.points, mesh.points);
  EXPECT_EQ(again.cells, mesh.cells);
  EXPECT_EQ(again.cell_regions, mesh.cell_regions);
  EXPECT_EQ(again.triangles, mesh.triangles);
  EXPECT_EQ(again.triangle_walls, mesh.triangle_walls);
  EXPECT_EQ(again.cell_numbers, mesh.cell_numbers);
  EXPECT_EQ(again.region_names, mesh.region_names);
  EXPECT_EQ(again.wall_names, mesh.wall_names);
}

TEST(RawMeshBytes, ThatAreCutShortAreRefused) {
  std::string bytes = bytes_of(kuhn_cube_raw());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(take_raw_mesh(std::string_view(bytes).substr(0, size)), std::runtime_error);
  // The number of names, which are the last.
  const std::size_t names = bytes.rfind("xmin") - 2 * sizeof(std::size_t);
  bytes.replace(names, sizeof(std::size_t), sizeof(std::size_t), '\x7f');
  EXPECT_THROW(take_raw_mesh(bytes), std::runtime_error);
}

}  // namespace
}  // namespace etendue::raw_mesh_bytes_test
