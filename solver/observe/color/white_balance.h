// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "base/vec3.h"
#include "solver/observe/color/band_color.h"
#include "solver/problem/bands.h"

namespace etendue {

/// Light that a picture shows as neutral: equal power in each nanometer, daylight D65, or a black body.
struct White {
  enum class Kind { equal, d65, black_body };
  Kind kind = Kind::equal;
  double kelvin = 0;  ///< of a black body [K]
};

/// Bradford's chromatic adaptation of tristimulus values X, Y, Z from one white to another (Lam 1985;
/// ICC.1:2022, annex E): a diagonal scaling in a space of sharpened cones.
Eigen::Matrix3d chromatic_adaptation(const Vec3& from, const Vec3& to);

/// How linear colors (BandColor) are adapted for a display, whose white is D65. A single band with
/// wavelengths under the white "equal" is grey of its luminance: its hue is all one. Bands that are the
/// primaries of sRGB are neutral already where they are equal, and bands without wavelengths are grey.
class WhiteBalance {
 public:
  explicit WhiteBalance(const Bands& bands, const White& white = {});

  LinearColor of(const LinearColor& color) const;
  /// "" where nothing is adapted, else what is neutral.
  const std::string& rule() const { return rule_; }

 private:
  Eigen::Matrix3d map_ = Eigen::Matrix3d::Identity();
  std::string rule_;
};

}  // namespace etendue
