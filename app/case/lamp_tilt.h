// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace etendue {

/// How the light of a lamp changes as its luminaire is tilted (LM-63-02, TILT).
struct LampTilt {
  std::vector<double>
      angle;  ///< [degree] between the luminaire's axis and straight down, rising; empty: none
  std::vector<double> factor;  ///< of the candelas

  /// Linear between the angles, 1 without any; empty beyond them.
  std::optional<double> factor_at(double degrees) const;
};

}  // namespace etendue
