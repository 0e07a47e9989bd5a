// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "solver/problem/bands.h"

namespace etendue {

using LinearColor = std::array<double, 3>;  ///< red, green, blue of sRGB before its transfer function

/// What bands look like together: a linear map from their radiance to linear sRGB (BT.709 primaries, white
/// D65). Bands called red, green and blue are these primaries. With edges the spectrum, constant in each
/// band, is seen by the CIE 1931 observer, and luminance is the radiance weighted by V (683 lm/W of it are
/// cd/m^2). Other bands, and those that the eye does not see, are shown as grey, their mean.
class BandColor {
 public:
  explicit BandColor(const Bands& bands);

  LinearColor of(std::span<const double> radiance) const;
  const std::string& rule() const { return rule_; }

 private:
  std::vector<LinearColor> of_band_;
  std::string rule_;
};

/// Linear sRGB of tristimulus values X, Y, Z.
LinearColor linear_srgb(const std::array<double, 3>& xyz);

/// Returns whether the bands are called red, green and blue.
bool are_primaries(const Bands& bands);

/// Luminance of a linear color (BT.709).
double luminance(const LinearColor& color);

}  // namespace etendue
