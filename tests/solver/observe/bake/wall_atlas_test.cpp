// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/bake/wall_atlas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/solver/observe/sensors/block_mesh.h"

namespace etendue::wall_atlas_test {
namespace {

TetrahedralMesh box() {
  return block_mesh({{{0, 0.5, 1, 2}, {0, 0.5, 1}, {0, 0.5, 1}}},
                    [](const Vec3&, const Vec3& out) { return out.z() > 0.5 ? "mouth" : "wall"; });
}

// Six sides, 10 of area: none overlap, and lengths are kept.
TEST(WallAtlas, KeepsLengthsAndCoversTheWallsOnce) {
  const TetrahedralMesh mesh = box();
  const WallSurface surface = wall_surface(mesh);
  const WallAtlas atlas = wall_atlas(surface, mesh, 128);
  for (const auto& [u, v] : atlas.coordinates) {
    EXPECT_TRUE(u > 0 && u < 1 && v > 0 && v < 1);
  }
  for (const auto& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(triangle[i]),
                 b = static_cast<std::size_t>(triangle[(i + 1) % 3]);
      const double here = std::hypot(atlas.coordinates[a][0] - atlas.coordinates[b][0],
                                     atlas.coordinates[a][1] - atlas.coordinates[b][1]);
      const double there = (surface.vertices[a].position - surface.vertices[b].position).norm();
      EXPECT_NEAR(here * atlas.side * atlas.texel, there, 1e-12);
    }
  EXPECT_EQ(std::set<std::size_t>(atlas.texels.begin(), atlas.texels.end()).size(), atlas.texels.size());
  std::size_t inside = 0;
  for (const BakePlace& place : atlas.places) inside += std::ranges::min(place.weights) > 1.0001e-4 ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(inside) * atlas.texel * atlas.texel, 10, 0.3);
  EXPECT_GT(static_cast<double>(inside), 0.5 * 128 * 128) << "no room is wasted";
}

// What a texel shows is the wall where the coordinates of the surface put it.
TEST(WallAtlas, PutsTexelsWhereCoordinatesSay) {
  const TetrahedralMesh mesh = box();
  const WallSurface surface = wall_surface(mesh);
  const WallAtlas atlas = wall_atlas(surface, mesh, 64);
  for (std::size_t i = 0; i < atlas.texels.size(); ++i) {
    const BakePlace& place = atlas.places[i];
    if (std::ranges::min(place.weights) < 1.0001e-4) continue;
    double u = 0, v = 0;
    for (const std::int32_t corner : surface.triangles[place.face.at()]) {
      const auto c = static_cast<std::size_t>(corner);
      const auto& at = mesh.vertices(place.face);
      for (std::size_t k = 0; k < 3; ++k)
        if ((mesh.point(VertexIndex(at[k])) - surface.vertices[c].position).norm() < 1e-12) {
          u += place.weights[k] * atlas.coordinates[c][0];
          v += place.weights[k] * atlas.coordinates[c][1];
        }
    }
    EXPECT_NEAR(u * 64, static_cast<double>(atlas.texels[i] % 64) + 0.5, 1e-9);
    EXPECT_NEAR(v * 64, static_cast<double>(atlas.texels[i] / 64) + 0.5, 1e-9);
  }
}

TEST(WallAtlas, RefusesMorePartsThanItHoldsTexelsFor) {
  const TetrahedralMesh mesh = box();
  const WallSurface surface = wall_surface(mesh);
  EXPECT_THROW(wall_atlas(surface, mesh, 8), InputError);
}

}  // namespace
}  // namespace etendue::wall_atlas_test
