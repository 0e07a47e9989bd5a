// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "solver/angular/sets/direction_set.h"

namespace etendue {

/// What a set integrates exactly, measured.
struct DirectionSetReport {
  int count = 0;
  double smallest_weight = 0;     ///< relative to the mean
  double largest_weight = 0;      ///< relative to the mean
  double first_moment_error = 0;  ///< |sum of w direction|
  double second_moment_error =
      0;  ///< largest entry of |sum of w direction direction^T - full range/dimension I|
  /// The highest up to which all spherical harmonics (so all polynomials) are exact to 1e-9; in the plane all
  /// cos(k t) and sin(k t). 159: or more.
  int degree = 0;
  /// Relative error of the half range along x, y, z; in the plane 0 along z.
  std::array<double, 3> axis_half_range_error{};
  double half_range_error_rms = 0;  ///< over 2,000 random normals
  /// Largest |sum of w p - 1| for Henyey-Greenstein, g = 0.8, over 2,000 or more of the ordinates.
  double kernel_row_error = 0;
};
DirectionSetReport report_directions(const DirectionSet& set);

}  // namespace etendue
