// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/patches/patch_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "solver/radiosity/patches/patch_neighbours.h"
#include "solver/radiosity/solve/patch_light.h"
#include "tests/solver/radiosity/radiosity_samples.h"

namespace etendue::patch_refinement_test {
namespace {

/// A function of the place as irradiance, in the middle of each patch.
template <class Function>
std::vector<double> in_middles(const WallPatches& patches, const Function& f) {
  std::vector<double> values;
  for (const FlatPatch& patch : patches.patches) values.push_back(f(patch.centroid()));
  return values;
}

WallPatches cut_for(const TetrahedralMesh& mesh, WallPatches patches, const RefinementRule& rule,
                    const std::function<double(const Vec3&)>& f) {
  for (int round = 0; round < 20; ++round) {
    const std::vector<bool> cut = patches_to_cut(mesh, patches, in_middles(patches, f), rule);
    if (std::ranges::count(cut, true) == 0) return patches;
    patches = refined_patches(mesh, patches, cut);
  }
  ADD_FAILURE() << "does not come to an end";
  return patches;
}

void expect_cover(const TetrahedralMesh& mesh, const WallPatches& patches) {
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    double share = 0;
    for (const FacePart& part : patches.of_faces[static_cast<std::size_t>(f)]) {
      share += part.share;
      EXPECT_EQ(patches.walls[part.patch], mesh.wall(FaceIndex(f)));
    }
    EXPECT_DOUBLE_EQ(share, 1);
  }
  std::vector<double> area(mesh.wall_names().size(), 0), faces = area;
  for (std::size_t p = 0; p < patches.patches.size(); ++p)
    area[static_cast<std::size_t>(patches.walls[p])] += patches.patches[p].area();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    faces[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] += mesh.area(FaceIndex(f));
  for (std::size_t w = 0; w < area.size(); ++w) EXPECT_NEAR(area[w], faces[w], 1e-12);
}

double edge_at(const Vec3& p) { return p.x() + 0.4 * p.y() > 0.63 ? 1 : 0; }

// Joined faces, whole faces and quarters of faces: walls keep their area, and the triangles are those of the
// patches.
TEST(PatchRefinement, KeepsTheAreaOfEachWall) {
  for (const double volume : {0.0005, 0.05})
    for (const double size : {0.0, 0.5}) {
      const TetrahedralMesh mesh = cube_mesh(volume);
      const WallPatches patches =
          cut_for(mesh, wall_patches(mesh, size), {.change = 0.2, .smallest = 0.06}, edge_at);
      EXPECT_GT(patches.patches.size(), wall_patches(mesh, size).patches.size());
      expect_cover(mesh, patches);
    }
}

// Along an edge of a shadow patches become as small as they may, and far from it they stay; between there and
// here neighbours differ by no more than a factor of three in size.
TEST(PatchRefinement, CutsAlongAShadowAlone) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  const WallPatches patches =
      cut_for(mesh, wall_patches(mesh, 0.4), {.change = 0.2, .smallest = 0.03}, edge_at);
  for (std::size_t p = 0; p < patches.patches.size(); ++p) {
    const Vec3& middle = patches.patches[p].centroid();
    const bool has_edge = patches.patches[p].normal().z() != 0;
    const double distance = std::abs(middle.x() + 0.4 * middle.y() - 0.63) / std::hypot(1, 0.4);
    if (has_edge && distance < 0.01) {
      EXPECT_LT(patches.patches[p].radius(), 0.04);
    }
    if (has_edge && distance > 0.4) {
      EXPECT_GT(patches.patches[p].radius(), 0.08);
    }
  }
  const auto neighbours = patch_neighbours(mesh, patches);
  for (std::size_t p = 0; p < neighbours.size(); ++p)
    for (const std::size_t q : neighbours[p]) EXPECT_LT(patches.sizes[p], 3 * patches.sizes[q]);
}

// A linear irradiance changes by as much everywhere: equal patches, of the size at which they meet the rule.
TEST(PatchRefinement, StopsWhereTheChangeIsSmall) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  const auto linear = [](const Vec3& p) { return p.z(); };
  const WallPatches patches = cut_for(mesh, wall_patches(mesh, 0.8), {.change = 0.2, .smallest = 0}, linear);
  const auto neighbours = patch_neighbours(mesh, patches);
  double largest = 0, smallest_side = 1;
  for (std::size_t p = 0; p < neighbours.size(); ++p)
    for (const std::size_t q : neighbours[p]) {
      largest =
          std::max(largest, std::abs(patches.patches[p].centroid().z() - patches.patches[q].centroid().z()));
      if (patches.patches[p].normal().z() == 0) smallest_side = std::min(smallest_side, patches.sizes[p]);
    }
  EXPECT_LE(largest, 0.2 * 0.5);
  EXPECT_GE(smallest_side, 0.1);
}

TEST(PatchNeighbours, AreThoseBeyondEdgesInThePlane) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  // Two triangles a wall, each with the other.
  const WallPatches whole = wall_patches(mesh, 0);
  const auto pairs = patch_neighbours(mesh, whole);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    ASSERT_EQ(pairs[p].size(), 1u);
    EXPECT_EQ(whole.walls[pairs[p][0]], whole.walls[p]);
  }
  // One of them cut in four: the other one has its two quarters along the edge and no more.
  std::vector<bool> cut(whole.patches.size(), false);
  cut[0] = true;
  const WallPatches parts = refined_patches(mesh, whole, cut);
  const auto neighbours = patch_neighbours(mesh, parts);
  ASSERT_EQ(parts.patches.size(), whole.patches.size() + 3);
  std::size_t edges = 0;
  for (std::size_t p = 0; p < neighbours.size(); ++p) {
    if (parts.walls[p] != parts.walls[0]) continue;
    edges += neighbours[p].size();
    for (const std::size_t q : neighbours[p]) EXPECT_EQ(parts.walls[q], parts.walls[p]);
  }
  EXPECT_EQ(edges, 2u * (3 + 2));
}

TEST(PatchLight, IsThatOfThePatchOnEachOfItsTriangles) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = empty_room(mesh, 0.5, "zmin");
  const WallPatches patches = wall_patches(mesh, 0.4);
  const auto height = [](const Vec3& p) { return 1 + p.z(); };
  const PatchLight light = light_on_patches(problem, patches, {in_middles(patches, height), {}, {}, {}});
  double area = 0;
  for (std::size_t t = 0; t < light.triangles.size(); ++t) {
    const auto p = static_cast<std::size_t>(light.patches[t]);
    const Vec3 normal =
        (light.triangles[t][1] - light.triangles[t][0]).cross(light.triangles[t][2] - light.triangles[t][0]);
    area += normal.norm() / 2;
    EXPECT_GT(normal.dot(Vec3(0.5, 0.5, 0.5) - light.triangles[t][0]), 0);
    EXPECT_EQ(light.walls[t], patches.walls[p]);
    EXPECT_DOUBLE_EQ(light.irradiance[t], height(patches.patches[p].centroid()));
    const bool shines = mesh.wall_names()[static_cast<std::size_t>(light.walls[t])] == "zmin";
    EXPECT_NEAR(light.exitance[t], (shines ? 1 : 0) + 0.5 * light.irradiance[t], 1e-12);
  }
  EXPECT_NEAR(area, 6, 1e-12);
}

}  // namespace
}  // namespace etendue::patch_refinement_test
