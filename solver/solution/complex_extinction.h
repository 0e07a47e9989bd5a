// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

namespace etendue {

/// What light that changes as e^(s t) adds to the extinction, s n / c with Re s >= 0 and Im s >= 0. Radiances
/// are complex then: of the problem's bands 2 p is the real and 2 p + 1 the imaginary part of one, and both
/// have the same media and walls.
struct ComplexExtinction {
  std::vector<double> real;       ///< [cell][pair of bands] Re s n / c [1/length]
  std::vector<double> imaginary;  ///< [cell][pair of bands] Im s n / c [1/length]

  bool empty() const { return imaginary.empty(); }
};

}  // namespace etendue
