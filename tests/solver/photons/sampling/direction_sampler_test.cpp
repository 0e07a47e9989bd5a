// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/sampling/direction_sampler.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "solver/angular/kernels/scattered_light.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/materials/kernels/leaf_canopy.h"

namespace etendue::direction_sampler_test {
namespace {

using std::numbers::pi;

/// Smooth functions of a direction that differ in every part of the sphere.
constexpr std::size_t functions = 5;
std::array<double, functions> values(const Vec3& before, const Vec3& after) {
  return {after.z(), after.z() * after.z(), after.dot(before), std::pow(after.dot(before), 2),
          after.x() + 2 * after.x() * after.y()};
}

/// Means of these over the kernel itself, by a product rule, and over what is drawn.
void expect_drawn_as_scattered(const DirectionalScattering& scattering, const Vec3& before) {
  const auto* leaves = std::get_if<LeafCanopy>(&scattering);
  const LeafNormals normals = leaves != nullptr ? leaf_normals(leaves->angles) : LeafNormals{};
  const DirectionSet set = directions_product(48);
  std::array<double, functions> exact{}, mean{}, square{};
  double total = 0;
  for (std::int32_t m = 0; m < set.count(); ++m) {
    const Vec3& after = set.direction(OrdinateIndex(m));
    const double weight = set.weight(OrdinateIndex(m)) * scattering_value(scattering, normals, before, after);
    total += weight;
    const auto f = values(before, after);
    for (std::size_t i = 0; i < functions; ++i) exact[i] += weight * f[i];
  }
  const auto sampler = make_direction_sampler(scattering);
  constexpr int count = 40000;
  for (int n = 0; n < count; ++n) {
    RandomStream stream(5, static_cast<std::uint64_t>(n), RandomUse::flight);
    DrawnNumbers random(stream);
    const Vec3 after = sampler->scattered(CellIndex(0), before, random);
    ASSERT_NEAR(after.norm(), 1, 1e-12);
    const auto f = values(before, after);
    for (std::size_t i = 0; i < functions; ++i) {
      mean[i] += f[i] / count;
      square[i] += f[i] * f[i] / count;
    }
  }
  for (std::size_t i = 0; i < functions; ++i) {
    const double error = std::sqrt((square[i] - mean[i] * mean[i]) / count);
    EXPECT_NEAR(mean[i], exact[i] / total, 4 * error + 2e-3)
        << directional_name(scattering) << ", function " << i << " from " << before.transpose();
  }
}

const std::array<Vec3, 3> befores = {Vec3(0.36, 0.48, 0.8), Vec3(-0.8, 0.6, 0), Vec3(0.1, -0.2, -1)};

TEST(DirectionSampler, DrawsWhereLeavesScatter) {
  for (std::size_t angles = 0; angles < leaf_angle_names().size(); ++angles)
    for (const Vec3& before : befores) {
      const LeafCanopy leaves{static_cast<LeafAngles>(angles), 0.4, 0.15};
      if (leaf_projection(leaves.angles, before.normalized()) > 0)
        expect_drawn_as_scattered(leaves, before.normalized());
    }
}

TEST(DirectionSampler, DrawsWhereFlakesScatter) {
  const Vec3 axis = Vec3(1, 2, 2).normalized();
  for (const auto& [along, across] : {std::array{1.0, 0.4}, std::array{0.3, 1.0}, std::array{0.7, 0.7}})
    for (const Vec3& before : befores)
      expect_drawn_as_scattered(MicroFlakes{axis, along, across, 0.8}, before.normalized());
}

}  // namespace
}  // namespace etendue::direction_sampler_test
