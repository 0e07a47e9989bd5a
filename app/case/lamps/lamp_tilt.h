// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace etendue {

/// How the light of a lamp changes as its luminaire is tilted (LM-63-02, TILT).
struct LampTilt {
  /// [degree] between the luminaire's axis and straight down, rising; empty: none
  std::vector<double> angle;
  std::vector<double> factor;  ///< of the candelas
  /// The lamp lies across the axis of the luminaire (geometries 2 and 3): whether it tilts too depends on the
  /// way in which the luminaire is turned, which factors over one angle do not tell.
  bool lies_across = false;

  /// Linear between the angles, 1 without any; empty beyond them.
  std::optional<double> factor_at(double degrees) const;
};

}  // namespace etendue
