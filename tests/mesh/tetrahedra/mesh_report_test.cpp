// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/mesh_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::mesh_report_test {
namespace {

TEST(MeshReport, AddsUpRegionsAndWalls) {
  const TetrahedralMesh mesh = two_region_mesh(1e-3);
  const MeshReport report = mesh_report(mesh);
  ASSERT_EQ(report.region_volumes.size(), 2u);
  EXPECT_NEAR(report.region_volumes[0], 0.875, 1e-12);
  EXPECT_NEAR(report.region_volumes[1], 0.125, 1e-12);
  EXPECT_EQ(report.region_cells[0] + report.region_cells[1], mesh.cell_count());
  ASSERT_EQ(report.wall_areas.size(), 6u);
  for (const double area : report.wall_areas) EXPECT_NEAR(area, 1, 1e-12);
  EXPECT_EQ(std::accumulate(report.wall_faces.begin(), report.wall_faces.end(), 0),
            mesh.boundary_face_count());
  EXPECT_EQ(std::accumulate(report.quality_histogram.begin(), report.quality_histogram.end(), 0),
            mesh.cell_count());
  EXPECT_GT(report.smallest_volume, 0);
  EXPECT_GE(report.largest_volume, 1.0 / mesh.cell_count());
}

TEST(MeshReport, RegularTetrahedronHasQualityOne) {
  RawMesh raw = single_tetrahedron_raw();
  raw.points = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  const MeshReport report = mesh_report(TetrahedralMesh(raw));
  EXPECT_NEAR(report.worst_quality, 1, 1e-14);
  EXPECT_EQ(report.quality_histogram[9], 1);
  EXPECT_LT(report.worst_centroid.norm(), 1e-15);
}

TEST(MeshReport, CornerTetrahedronHasItsKnownQuality) {
  // r_in = 1/(3 + sqrt 3), r_circum = sqrt(3)/2.
  const MeshReport report = mesh_report(single_tetrahedron());
  EXPECT_NEAR(report.worst_quality, 6 / (std::sqrt(3.0) * (3 + std::sqrt(3.0))), 1e-14);
  EXPECT_EQ(report.quality_histogram[7], 1);
}

TEST(MeshReport, PrintsTables) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  const std::string text = to_string(mesh_report(mesh), mesh, "m");
  EXPECT_EQ(text.find("6 cells, 18 faces, 8 vertices\n"
                      "  region      cells  volume [m^3]\n"
                      "  domain          6             1\n"
                      "  sum             6             1\n"
                      "  wall      faces    area [m^2]\n"
                      "  xmin          2             1\n"),
            0u)
      << text;
  EXPECT_NE(text.find("cell volumes from 0.166667 to 0.166667 m^3\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  0.5 ... 0.6         0\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace etendue::mesh_report_test
