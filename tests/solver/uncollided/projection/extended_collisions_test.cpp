// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Light of a flat lamp past a sheet that scatters forward: its directions in one band do not depend on
// another band, in which no ray finds any light.
#include "solver/uncollided/projection/extended_collisions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/solver/uncollided/obstacle_room.h"

namespace etendue::extended_collisions_test {
namespace {

constexpr double opaque = 1e5;

UncollidedField field_of(const TetrahedralMesh& mesh, const std::vector<double>& absorption) {
  const auto bands = static_cast<int>(absorption.size());
  Medium haze = uniform_medium(bands, 0, 1, 0, PhaseHenyeyGreenstein{0.8});
  haze.absorption.assign(absorption.begin(), absorption.end());
  Light lamp = flat_light(rectangle(0.2, 0.15));
  std::get<SurfaceLight>(lamp.kind).radiance.assign(absorption.size(), 1);
  const Problem problem(mesh, {std::vector<std::string>(absorption.size(), "band"), {}}, {haze},
                        std::vector<Wall>(mesh.wall_names().size(), uniform_wall(bands, 0, 0, 0)),
                        AngularSpace::sphere, {lamp});
  const LightSetup lights(problem);
  return uncollided_field(lights.paths(), lights.sources(), 1);
}

/// Nodal values of a band [direction][4].
std::map<int, std::array<double, 4>> collisions(const UncollidedField& field, CellIndex cell,
                                                std::size_t bands) {
  std::map<int, std::array<double, 4>> found;
  const auto directions = field.collisions.directions_at(cell);
  for (std::size_t k = 0; k < directions.size(); ++k)
    for (std::size_t i = 0; i < 4; ++i) found[directions[k]][i] = field.collisions.values(cell, k)[i * bands];
  return found;
}

TEST(ExtendedCollisions, OfABandDoNotDependOnAnother) {
  const TetrahedralMesh mesh = room_with(Obstacle::sheet, 1e-2);
  const UncollidedField alone = field_of(mesh, {0.1}), beside = field_of(mesh, {0.1, opaque});
  int lit = 0;
  double largest = 0, difference = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    auto expected = collisions(alone, CellIndex(c), 1), found = collisions(beside, CellIndex(c), 2);
    if (!expected.empty()) ++lit;
    for (const auto& [direction, values] : found) expected[direction];
    for (const auto& [direction, values] : expected)
      for (std::size_t i = 0; i < 4; ++i) {
        largest = std::max(largest, std::abs(values[i]));
        difference = std::max(difference, std::abs(values[i] - found[direction][i]));
      }
  }
  EXPECT_GT(lit, 300);
  // Bands share the grid of directions, the coarseness of which goes by the light of all of them.
  EXPECT_LT(difference, 2e-3 * largest);
}

}  // namespace
}  // namespace etendue::extended_collisions_test
