// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

namespace etendue {

/// A line of gray_gases/bordbar_2014.csv: what a quantity of a gas is by the molar ratio.
struct BordbarLine {
  enum Quantity { absorption, weight_0, weight_1, weight_2, weight_3, weight_4 };
  int gas;
  Quantity quantity;
  double ratio_0, ratio_1, ratio_2, ratio_3, ratio_4;
};
std::span<const BordbarLine> bordbar_lines();

/// A line of gray_gases/smith_1982.csv: a gas of a molar ratio.
struct SmithLine {
  int molar_ratio;
  double absorption, weight_0, weight_1, weight_2, weight_3;
};
std::span<const SmithLine> smith_lines();

}  // namespace etendue
