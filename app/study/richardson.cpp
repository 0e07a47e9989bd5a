// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/richardson.h"

#include <cmath>

namespace etendue {
namespace {

constexpr double lowest_order = 0.1;
constexpr double highest_order = 10;
// Halvings of that interval until an order is exact to rounding.
constexpr int halvings = 60;

}  // namespace

std::optional<Extrapolation> richardson(const std::array<double, 3>& sizes,
                                        const std::array<double, 3>& values) {
  const auto [coarse, middle, fine] = sizes;
  if (!(coarse > middle && middle > fine && fine > 0)) return std::nullopt;
  const double wanted = (values[0] - values[1]) / (values[1] - values[2]);
  // Rises with the order.
  const auto ratio = [&](double order) {
    return (std::pow(coarse / middle, order) - 1) / (1 - std::pow(fine / middle, order));
  };
  double low = lowest_order, high = highest_order;
  if (!std::isfinite(wanted) || !(ratio(low) < wanted && wanted < ratio(high))) return std::nullopt;
  for (int i = 0; i < halvings; ++i) {
    const double order = (low + high) / 2;
    (ratio(order) < wanted ? low : high) = order;
  }
  const double shrinkage = std::pow(middle / fine, low) - 1;
  return Extrapolation{values[2] - (values[1] - values[2]) / shrinkage, low};
}

}  // namespace etendue
