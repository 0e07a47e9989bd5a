// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/white_balance.h"

#include <fmt/format.h>

#include <Eigen/LU>

#include "base/blackbody.h"
#include "solver/observe/color/color_matching.h"

namespace etendue {
namespace {

// The wavelengths of the color-matching functions [nm].
constexpr int shortest = 360, longest = 830;

Vec3 as_vector(const std::array<double, 3>& values) { return {values[0], values[1], values[2]}; }

Vec3 tristimulus(const White& white) {
  if (white.kind != White::Kind::black_body) return as_vector(mean_color_matching(shortest, longest));
  Vec3 sum = Vec3::Zero();
  for (int nm = shortest; nm < longest; ++nm)
    sum += (planck_fraction(nm + 1, white.kelvin) - planck_fraction(nm, white.kelvin)) *
           as_vector(mean_color_matching(nm, nm + 1));
  return sum;
}

Eigen::Matrix3d srgb_of_xyz() {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) {
    std::array<double, 3> unit{};
    unit[static_cast<std::size_t>(i)] = 1;
    matrix.col(i) = as_vector(linear_srgb(unit));
  }
  return matrix;
}

}  // namespace

Eigen::Matrix3d chromatic_adaptation(const Vec3& from, const Vec3& to) {
  Eigen::Matrix3d cones;
  cones << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296;
  const Vec3 scale = (cones * to / to.y()).cwiseQuotient(cones * from / from.y());
  return cones.inverse() * scale.asDiagonal() * cones;
}

WhiteBalance::WhiteBalance(const Bands& bands, const White& white) {
  const bool primaries = are_primaries(bands);
  if (white.kind == White::Kind::d65 || (bands.edges.empty() && !primaries)) return;
  const bool equal = white.kind == White::Kind::equal;
  if (primaries && equal) return;
  if (equal && bands.names.size() == 1) {
    for (int i = 0; i < 3; ++i)
      map_.col(i).setConstant(luminance({i == 0 ? 1. : 0., i == 1 ? 1. : 0., i == 2 ? 1. : 0.}));
    rule_ = "the one band as grey";
    return;
  }
  const Eigen::Matrix3d to_rgb = srgb_of_xyz(), to_xyz = to_rgb.inverse();
  const Vec3 display_white = to_xyz * Vec3::Ones();
  map_ = to_rgb * chromatic_adaptation(tristimulus(white), display_white) * to_xyz;
  rule_ = equal ? "equal power in each nanometer is neutral"
                : fmt::format("the light of a black body of {:.6g} K is neutral", white.kelvin);
}

LinearColor WhiteBalance::of(const LinearColor& color) const {
  const Vec3 adapted = map_ * as_vector(color);
  return {adapted.x(), adapted.y(), adapted.z()};
}

}  // namespace etendue
