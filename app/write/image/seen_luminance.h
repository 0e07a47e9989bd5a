// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "app/case/case.h"
#include "solver/observe/color/photometry.h"

namespace etendue {

/// Radiance and irradiance of a case's bands and units as the eye sees them. The case must have units of the
/// SI and bands that the eye sees.
class SeenLuminance {
 public:
  explicit SeenLuminance(const Case& input);

  /// Of radiance [band], in cd/m^2; of irradiance, in lx.
  double in_si(std::span<const double> radiant) const { return scale_ * photometry_.luminous(radiant); }
  /// Meters of a unit of length.
  double meters() const { return meters_; }

 private:
  Photometry photometry_;
  double scale_;
  double meters_;
};

}  // namespace etendue
