// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

namespace etendue {

/// Radiances of blackbodies and their derivatives by the unknown, [unknown][band]. Below a temperature of
/// zero radiances are those above it, and negative.
struct Blackbodies {
  std::vector<double> radiance;  ///< [W/(m^2 sr)]
  std::vector<double> slope;     ///< [W/(m^2 sr K)]
};

}  // namespace etendue
