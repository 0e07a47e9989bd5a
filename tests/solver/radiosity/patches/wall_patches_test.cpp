// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/patches/wall_patches.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/radiosity/radiosity_samples.h"

namespace etendue::wall_patches_test {
namespace {

/// Every face's parts add up to it, and patches cover the walls.
void expect_cover(const TetrahedralMesh& mesh, const WallPatches& walls) {
  double area = 0, faces = 0;
  for (const FlatPatch& patch : walls.patches) area += patch.area();
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    faces += mesh.area(FaceIndex(f));
    double share = 0;
    for (const FacePart& part : walls.of_faces[static_cast<std::size_t>(f)]) {
      share += part.share;
      EXPECT_EQ(walls.walls[part.patch], mesh.wall(FaceIndex(f)));
    }
    EXPECT_NEAR(share, 1, 1e-12);
  }
  EXPECT_NEAR(area, faces, 1e-12);
}

TEST(WallPatches, AreTheFacesWithoutASize) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const WallPatches walls = wall_patches(mesh, 0);
  EXPECT_EQ(walls.patches.size(), static_cast<std::size_t>(mesh.boundary_face_count()));
  expect_cover(mesh, walls);
}

TEST(WallPatches, AreCutAndJoinedToASize) {
  const TetrahedralMesh mesh = cube_mesh(0.001);
  const WallPatches joined = wall_patches(mesh, 0.5), cut = wall_patches(mesh, 0.05);
  EXPECT_EQ(joined.patches.size(), 24u);
  EXPECT_GT(cut.patches.size(), static_cast<std::size_t>(mesh.boundary_face_count()));
  for (const FlatPatch& patch : cut.patches) EXPECT_LE(patch.radius(), 0.05);
  expect_cover(mesh, joined);
  expect_cover(mesh, cut);
}

// Values of patches that are linear on a wall: means over faces stay, and at a vertex there is a quarter of
// what it has more than the middle.
TEST(WallPatches, HaveMeansAtVerticesThatKeepThoseOfFaces) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const WallPatches walls = wall_patches(mesh, 0.1);
  std::vector<double> values;
  for (const FlatPatch& patch : walls.patches) values.push_back(1 + patch.centroid().x());
  const std::vector<double> means = means_at_vertices(mesh, walls, values, 1);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const auto at = 3 * static_cast<std::size_t>(f);
    const double middle = mesh.centroid(FaceIndex(f)).x();
    EXPECT_NEAR((means[at] + means[at + 1] + means[at + 2]) / 3, 1 + middle, 1e-12);
    for (std::size_t i = 0; i < 3; ++i) {
      const double here = mesh.point(VertexIndex(mesh.vertices(FaceIndex(f))[i])).x();
      EXPECT_NEAR(means[at + i], 1 + middle + (here - middle) / 4, 0.02);
    }
  }
}

TEST(WallPatches, LookIntoTheDomain) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  for (const FlatPatch& patch : wall_patches(mesh, 0.4).patches)
    EXPECT_GT(patch.normal().dot(Vec3(0.5, 0.5, 0.5) - patch.centroid()), 0.49);
}

}  // namespace
}  // namespace etendue::wall_patches_test
