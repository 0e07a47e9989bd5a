// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/coordinate_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace etendue {
namespace {

constexpr double largest = 1e60, smallest = 1e-50;

}  // namespace

const Vec3& checked_range(const Vec3& point) {
  if (point.cwiseAbs().maxCoeff() <= largest) return point;
  throw std::invalid_argument(
      fmt::format("point ({:.6g}, {:.6g}, {:.6g}), scaled: use coordinates up to {:g}", point.x(), point.y(),
                  point.z(), largest));
}

void check_extent(const std::vector<Vec3>& points) {
  double most = 0;
  for (const Vec3& point : points) most = std::max(most, point.cwiseAbs().maxCoeff());
  if (!points.empty() && most < smallest)
    throw std::invalid_argument(fmt::format(
        "all coordinates, scaled, are at most {:.3g}: use a surface of at least {:g}", most, smallest));
}

}  // namespace etendue
