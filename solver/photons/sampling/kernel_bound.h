// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "base/random/drawn_numbers.h"
#include "solver/materials/kernels/directional_scattering.h"

namespace etendue {

/// Upper bound of a kernel by a formula at each angle of deflection, whatever the direction before and the
/// azimuth: constant in rings, of which half lie within 60 degrees. Directions are drawn from it and kept as
/// often as the kernel is large there.
class KernelBound {
 public:
  /// Looks at the kernel at some places. Throws InputError (without a file), naming the directions, where a
  /// value is negative or not finite beside straight ahead.
  KernelBound(const KernelFormula& kernel, const std::vector<Vec3>& places);

  double total() const { return cumulative_.back(); }  ///< over all directions [1/length]
  struct Draw {
    Vec3 after;
    double bound;  ///< [1/(length sr)] there
  };
  Draw draw(const Vec3& before, DrawnNumbers& random) const;

 private:
  void look(const KernelFormula& kernel, const Vec3& before, const Vec3& after);

  std::vector<double> bound_;       ///< [ring]
  std::vector<double> cumulative_;  ///< [ring] of the integral over it and those before
};

}  // namespace etendue
