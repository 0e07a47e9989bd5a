// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/rotation.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/angular/sets/direction_set.h"

namespace etendue {

Rotation rotation_about(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
}

// A point on the sphere in four dimensions is a quaternion; uniform points give uniform rotations
// (Shoemake 1992).
Rotation random_rotation(std::uint64_t seed, AngularSpace space) {
  std::mt19937_64 random(seed);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  if (space == AngularSpace::plane) return rotation_about(Vec3::UnitZ(), 360 * uniform());
  const double share = uniform();
  const double first = 2 * std::numbers::pi * uniform(), second = 2 * std::numbers::pi * uniform();
  const double a = std::sqrt(1 - share), b = std::sqrt(share);
  const Eigen::Quaterniond quaternion(b * std::cos(second), a * std::sin(first), a * std::cos(first),
                                      b * std::sin(second));
  return quaternion.normalized().toRotationMatrix();
}

DirectionSet rotated(const DirectionSet& set, const Rotation& rotation) {
  std::vector<Vec3> directions;
  directions.reserve(set.directions().size());
  for (const Vec3& direction : set.directions()) directions.push_back((rotation * direction).normalized());
  return DirectionSet("rotated " + set.name(), set.order(), directions,
                      {set.weights().begin(), set.weights().end()}, set.space());
}

std::vector<DirectionSet> rotated_copies(const DirectionSet& set, int count, std::uint64_t seed) {
  std::vector<DirectionSet> sets = {set};
  for (int k = 1; k < count; ++k)
    sets.push_back(rotated(set, random_rotation(seed + static_cast<std::uint64_t>(k), set.space())));
  return sets;
}

}  // namespace etendue
