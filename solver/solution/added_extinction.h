// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace etendue {

/// What light that changes with time adds to the extinction [1/length]: s n / c where it changes as e^(s t)
/// with Re s >= 0 and Im s >= 0, n / (c h) in a step. With an imaginary part radiances are complex: of the
/// problem's bands 2 p is the real and 2 p + 1 the imaginary part of one, and both have the same media and
/// walls.
struct AddedExtinction {
  std::vector<double> real;       ///< [cell][band], or [cell][pair of bands]; empty: nothing is added
  std::vector<double> imaginary;  ///< [cell][pair of bands]; empty: radiances are real

  bool is_complex() const { return !imaginary.empty(); }
  /// The real part at a place in [cell][band].
  double real_at(std::size_t at) const { return real.empty() ? 0 : real[is_complex() ? at / 2 : at]; }
};

}  // namespace etendue
