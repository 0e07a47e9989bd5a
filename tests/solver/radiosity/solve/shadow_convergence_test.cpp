// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "tests/solver/radiosity/radiosity_samples.h"

namespace etendue::shadow_convergence_test {
namespace {

const Vec3 board_min(0.35, 0.3, 0.4), board_max(0.6, 0.65, 0.45);
constexpr double lamp_low = 0.45, lamp_high = 0.55;

/// A cube of side 1 with a board under a lamp in the ceiling.
TetrahedralMesh room_with_board() {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "air";
  geometry.primitives.emplace_back(room);
  BoxPrimitive board;
  board.hole = true;
  board.name = "board";
  board.min = board_min;
  board.max = board_max;
  geometry.primitives.emplace_back(board);
  geometry.patches.push_back({"lamp", {lamp_low, lamp_low, 1}, {lamp_high, lamp_high, 1}, {}});
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{0.05}, 1.4, {}}));
}

bool passes_the_board(const Vec3& from, const Vec3& to) {
  const Vec3 separation = to - from;
  double begin = 0, end = 1;
  for (Eigen::Index x = 0; x < 3; ++x) {
    const double a = (board_min[x] - from[x]) / separation[x], b = (board_max[x] - from[x]) / separation[x];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin >= end;
}

/// Of the lamp alone, exitance 1, on the floor: the sum over a fine grid on the lamp.
double exact_irradiance(double x, double y) {
  constexpr int parts = 24;
  constexpr double step = (lamp_high - lamp_low) / parts;
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    for (int k = 0; k < parts; ++k) {
      const Vec3 from(x + 1e-9, y + 1e-9, 0);
      const Vec3 to(lamp_low + (i + 0.5) * step, lamp_low + (k + 0.5) * step, 1);
      if (passes_the_board(from, to))
        sum += step * step / (std::numbers::pi * std::pow((to - from).squaredNorm(), 2));
    }
  return sum;
}

/// Mean |H - exact| over a grid on the floor, of the mean there.
double error_on_the_floor(const RadiosityRoom& room, const PatchLight& light) {
  const WallPatches& patches = room.patches();
  std::vector<std::size_t> floor;
  for (std::size_t t = 0; t < light.triangles.size(); ++t)
    if (patches.patches[static_cast<std::size_t>(light.patches[t])].centroid().z() == 0) floor.push_back(t);
  const auto value_at = [&](const Vec3& point) {
    for (const std::size_t t : floor) {
      const TriangleCorners& c = light.triangles[t];
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i)
        inside = inside && (c[(i + 1) % 3] - c[i]).cross(point - c[i]).z() >= -1e-12;
      if (inside) return light.irradiance[t];
    }
    ADD_FAILURE() << "no patch there";
    return 0.0;
  };
  constexpr int grid = 96;
  double error = 0, mean = 0;
  for (int i = 0; i < grid; ++i)
    for (int k = 0; k < grid; ++k) {
      const double x = (i + 0.5) / grid, y = (k + 0.5) / grid, exact = exact_irradiance(x, y);
      mean += exact;
      error += std::abs(value_at({x, y, 0}) - exact);
    }
  return error / mean;
}

struct Found {
  std::size_t patches;
  double error;
};

Found found_with(const TetrahedralMesh& mesh, double size, const RefinementRule& rule) {
  const Problem problem = empty_room(mesh, 0, "lamp");
  RadiosityOptions options;
  options.patch_size = size;
  options.refinement = rule;
  options.rays = 4;
  options.threads = 2;
  RadiosityRoom room(problem, options);
  room.solve();
  return {room.report().patches,
          error_on_the_floor(room, light_on_patches(problem, room.patches(), room.solved()))};
}

// What a lamp and a board between it and the floor leave on the floor.
TEST(ShadowConvergence, PatchesCutAtTheShadowNeedFewerForTheSameError) {
  const TetrahedralMesh mesh = room_with_board();
  const Found even = found_with(mesh, 0.2, {});
  const Found cut = found_with(mesh, 0.4, {.change = 1, .smallest = 0.05});
  EXPECT_LT(cut.patches, 1.1 * static_cast<double>(even.patches));
  EXPECT_LT(cut.error, 0.65 * even.error);
}

}  // namespace
}  // namespace etendue::shadow_convergence_test
