// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/lights/beam_profile.h"

#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;
constexpr double turn_of_side = 2 * pi / beam_sides;

}  // namespace

double disc_apothem() { return std::sqrt(pi / (beam_sides * std::tan(turn_of_side / 2))); }

Vec3 disc_side(const BeamProfile& profile, int side) {
  return std::cos(side * turn_of_side) * profile.across + std::sin(side * turn_of_side) * profile.upright;
}

double distance_from_axis(const BeamProfile& profile, const Vec3& point) {
  const Vec3 from = point - profile.center;
  return std::hypot(profile.across.dot(from), profile.upright.dot(from));
}

double relative_irradiance(const BeamProfile& profile, const Vec3& point) {
  const double r = distance_from_axis(profile, point);
  if (profile.shape == BeamProfile::Shape::gaussian) return r < gaussian_end ? std::exp(-2 * r * r) : 0;
  const Vec3 from = point - profile.center;
  const double angle = std::atan2(profile.upright.dot(from), profile.across.dot(from));
  return r * std::cos(std::remainder(angle, turn_of_side)) <= disc_apothem() ? 1 : 0;
}

double profile_area(BeamProfile::Shape shape, double radius) {
  return (shape == BeamProfile::Shape::gaussian ? 0.5 : 1) * pi * radius * radius;
}

}  // namespace etendue
