// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

namespace etendue {

/// The CIE 1931 colour-matching functions of 2 degrees (x, y, z), y being the luminous efficiency V, as means
/// over a band of wavelengths [nm], in either order. The table is linear between its points, 1 nm apart, and
/// zero outside of 360 to 830 nm.
std::array<double, 3> mean_color_matching(double from, double to);

}  // namespace etendue
