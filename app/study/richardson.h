// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace etendue {

/// Where a value goes as the size goes to 0.
struct Extrapolation {
  double value = 0;
  double order = 0;
};

/// Richardson's extrapolation (1911) through value(size) = limit + c size^order, at three sizes that fall,
/// the ratios as they are. Nothing where the values do not approach a limit from one side, or the order would
/// not be between 0.1 and 10.
std::optional<Extrapolation> richardson(const std::array<double, 3>& sizes,
                                        const std::array<double, 3>& values);

}  // namespace etendue
