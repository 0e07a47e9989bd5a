// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

namespace etendue {

enum class FalseColorQuantity {
  luminance,  ///< as the eye sees the bands, in the unit of `units.luminance`
  radiance    ///< of all bands together [power/(length^2 sr)]
};

/// A picture in the colors of a scale.
struct FalseColor {
  FalseColorQuantity quantity = FalseColorQuantity::luminance;
  std::optional<double> least;  ///< at the lower end; empty: 0, of a logarithmic scale a thousandth of `most`
  std::optional<double> most;   ///< at the upper end; empty: the largest value of the picture
  bool logarithmic = false;
};

}  // namespace etendue
