// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/patches/patch_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/radiosity/exchange/node_exchange.h"
#include "solver/radiosity/form_factors/exchange_area.h"
#include "tests/solver/radiosity/radiosity_samples.h"
#include "tests/solver/radiosity/reference_shapes.h"

namespace etendue::patch_tree_test {
namespace {

TEST(PatchTree, HoldsEachPatchOnceInBallsAndBetweenPlanes) {
  for (const std::vector<FlatPatch>& patches :
       {sphere_patches(3), wall_patches(cube_mesh(0.01), 0.3).patches}) {
    const PatchTree tree(patches);
    EXPECT_EQ(tree.nodes().size(), 2 * patches.size() - 1);
    std::vector<std::int32_t> seen(tree.order());
    std::ranges::sort(seen);
    for (std::size_t p = 0; p < patches.size(); ++p) EXPECT_EQ(seen[p], static_cast<std::int32_t>(p));
    for (const PatchNode& node : tree.nodes()) {
      double area = 0, sampled = 0;
      Vec3 middle = Vec3::Zero();
      for (const std::int32_t p : tree.patches_of(node)) {
        const FlatPatch& patch = patches[static_cast<std::size_t>(p)];
        area += patch.area();
        EXPECT_LE((patch.normal() - node.axis).norm(), node.spread + 1e-12);
        for (const TriangleCorners& t : patch.triangles())
          for (const Vec3& corner : t) {
            EXPECT_LE((corner - node.center).norm(), node.radius + 1e-12);
            EXPECT_LE(std::abs((corner - node.center).dot(node.axis)), node.thickness + 1e-12);
          }
      }
      for (std::size_t i = 0; i < static_cast<std::size_t>(node.sample_count); ++i) {
        sampled += node.samples[i].area;
        middle += node.samples[i].area * node.samples[i].position;
      }
      EXPECT_NEAR(node.area, area, 1e-12);
      EXPECT_NEAR(sampled, area, 1e-12);
      EXPECT_LT((middle / sampled - node.center).norm(), 1e-12);
    }
  }
}

TEST(PatchTree, DrawsPointsEvenlyByArea) {
  const std::vector<FlatPatch> patches = wall_patches(cube_mesh(0.01), 0).patches;
  const PatchTree tree(patches);
  constexpr int strata = 40;
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < strata * strata; ++i) {
    const SurfaceSite site =
        tree.site_of(tree.nodes()[0], (i + 0.5) / (strata * strata), (i % strata + 0.5) / strata, 0.5);
    mean += site.position / (strata * strata);
    EXPECT_GT(site.normal.dot(Vec3(0.5, 0.5, 0.5) - site.position), 0.49);
  }
  EXPECT_LT((mean - Vec3(0.5, 0.5, 0.5)).norm(), 0.02);
}

/// A square of four by four parts in a plane z = height, that looks up or down.
std::vector<FlatPatch> square_parts(double height, double looks) {
  std::vector<FlatPatch> parts;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) {
      std::array<Vec3, 4> corners = {Vec3(i, k, height), Vec3(i + 1, k, height), Vec3(i + 1, k + 1, height),
                                     Vec3(i, k + 1, height)};
      if (looks < 0) std::swap(corners[1], corners[3]);
      parts.push_back(FlatPatch::polygon(corners));
    }
  return parts;
}

// Far apart the mean is the exchange area over both areas, to second order as there are eight samples of the
// sixteen squares; and so does fall what the linear fit leaves, beside the mean.
TEST(NodeKernel, IsLinearInBothPlaces) {
  double last_error = 1, last_residual = 1;
  for (const double height : {10.0, 20.0, 40.0}) {
    const std::vector<FlatPatch> low = square_parts(0, 1), high = square_parts(height, -1);
    const PatchTree a(low), b(high);
    const NodeKernel kernel = node_kernel(a.nodes()[0], b.nodes()[0]);
    double exact = 0;
    for (const FlatPatch& p : low)
      for (const FlatPatch& q : high) exact += exchange_area(p, q);
    const double error = std::abs(kernel.mean * 16 * 16 / exact - 1);
    const double residual = kernel.residual / kernel.mean;
    EXPECT_LT(error, last_error / 3.4);
    EXPECT_LT(residual, last_residual / 3.4);
    last_error = error;
    last_residual = residual;
  }
  EXPECT_LT(last_error, 0.002);
}

TEST(NodeExchange, KnowsWhatIsBehind) {
  const std::vector<FlatPatch> low = square_parts(0, 1), high = square_parts(3, -1),
                               away = square_parts(3, 1);
  const PatchTree a(low), b(high), c(away);
  EXPECT_FALSE(are_behind(a.nodes()[0], b.nodes()[0]));
  EXPECT_TRUE(are_behind(a.nodes()[0], c.nodes()[0]));
  EXPECT_TRUE(are_behind(a.nodes()[1], a.nodes()[2]));
  EXPECT_FALSE(are_apart(a.nodes()[0], b.nodes()[0]));
}

}  // namespace
}  // namespace etendue::patch_tree_test
