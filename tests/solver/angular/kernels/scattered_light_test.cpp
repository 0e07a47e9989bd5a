// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/kernels/scattered_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "solver/angular/sets/sphere_table.h"

namespace etendue::scattered_light_test {
namespace {

TEST(SphereTable, KnowsSmoothFunctionsBetweenItsNodes) {
  const auto smooth = [](const Vec3& w) { return 1 + w.z() * w.z() + 0.3 * w.x() * w.y() + 0.2 * w.y(); };
  const SphereTable table(48, smooth);
  const DirectionSet set = rotated(directions_ldfe_sq(2), rotation_about(Vec3(1, 2, 3).normalized(), 40));
  for (const Vec3& w : set.directions()) EXPECT_NEAR(table.at(w), smooth(w), 5e-6);
  for (const Vec3& w : {Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitZ()), Vec3(-Vec3::UnitX())})
    EXPECT_NEAR(table.at(w), smooth(w), 1e-12);
}

// The table halves its steps: cubics fall at order 4.
TEST(SphereTable, ConvergesAtOrderFour) {
  const auto smooth = [](const Vec3& w) { return std::exp(w.x() + 0.5 * w.z()); };
  const DirectionSet set = rotated(directions_ldfe_sq(2), rotation_about(Vec3(1, 2, 3).normalized(), 40));
  double last = 0;
  for (const int rows : {8, 16, 32}) {
    const SphereTable table(rows, smooth);
    double error = 0;
    for (const Vec3& w : set.directions()) error = std::max(error, std::abs(table.at(w) - smooth(w)));
    if (last > 0) {
      EXPECT_GT(std::log2(last / error), 3.5);
    }
    last = error;
  }
}

TEST(ScatteredLight, OfLeavesIsTheSumOverTheirNormals) {
  const DirectionSet set = directions_ldfe_sq(1);
  const ScatteredLight::Beams beams = {{Vec3(0.2, -0.4, -0.8).normalized(), 1.5}, {Vec3::UnitX(), 0.5}};
  std::vector<double> values(static_cast<std::size_t>(set.count()));
  for (const LeafAngles angles : {LeafAngles::horizontal, LeafAngles::planophile, LeafAngles::vertical}) {
    const LeafCanopy leaves{angles, 0.3, 0.1};
    ScatteredLight(leaves, set).scatter(beams, values);
    const LeafNormals normals = leaf_normals(angles);
    for (std::size_t m = 0; m < values.size(); ++m) {
      double expected = 0;
      for (const auto& [direction, fluence] : beams)
        expected += fluence * scattering_value(leaves, normals, direction, set.directions()[m]);
      EXPECT_NEAR(values[m], expected, 1e-14);
    }
  }
}

// What the ordinates get is what the light loses, to what the set makes of the kernel's integral.
TEST(ScatteredLight, KeepsTheEnergyOfSmoothKernels) {
  const DirectionSet set = directions_ldfe_sq(2);
  const Vec3 travel = Vec3(0.3, -0.5, -0.7).normalized();
  std::vector<double> values(static_cast<std::size_t>(set.count()));
  const auto sent = [&](const DirectionalScattering& scattering) {
    ScatteredLight(scattering, set).scatter({{travel, 1.0}}, values);
    double sum = 0;
    for (std::size_t m = 0; m < values.size(); ++m) sum += set.weights()[m] * values[m];
    return sum;
  };
  EXPECT_NEAR(sent(LeafCanopy{LeafAngles::erectophile, 0.4, 0.3}),
              0.7 * leaf_projection(LeafAngles::erectophile, travel), 2e-3);
  EXPECT_NEAR(sent(MicroFlakes{Vec3::UnitZ(), 1, 1, 0.8}), 0.8, 1e-12);
  KernelFormula even;
  even.formula = std::make_shared<Expression>("(1 + wx*vx + wy*vy + wz*vz)/(4*pi)", kernel_variables());
  EXPECT_NEAR(sent(even), 1, 1e-12);
}

}  // namespace
}  // namespace etendue::scattered_light_test
