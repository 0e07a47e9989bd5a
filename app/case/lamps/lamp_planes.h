// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

namespace etendue {

/// More planes or angles than any lamp file has.
inline constexpr int most_lamp_angles = 10000;

/// Intensities of a lamp file: [plane][angle].
using LampPlanes = std::vector<std::vector<double>>;

/// Adds the planes 2 about - p for those p below `about`: the lamp is symmetric there.
void mirror_planes(double about, std::vector<double>& angles, LampPlanes& planes);

/// Whether all planes have the same intensities but for rounding.
bool all_alike(const LampPlanes& planes);

}  // namespace etendue
