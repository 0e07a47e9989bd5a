// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/quadrature/gauss_legendre.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/angular/sets/octant.h"

namespace etendue {
namespace {

/// One level z = const: `count` azimuths at half steps in the first quadrant, sharing the level's solid
/// angle. x and y swap exactly: sin of one azimuth is taken as cos of its mirror image at 45 degrees.
void append_level(WeightedDirections& octant, double z, double level_weight, int count) {
  const double radius = std::sqrt((1 - z) * (1 + z));
  const auto cosine = [count](int j) { return std::cos(std::numbers::pi / 2 * (j + 0.5) / count); };
  for (int j = 0; j < count; ++j) {
    octant.directions.emplace_back(radius * cosine(j), radius * cosine(count - 1 - j), z);
    octant.weights.push_back(level_weight * std::numbers::pi / 2 / count);
  }
}

/// All levels of an octant, mirrored.
DirectionSet mirrored_set(const char* name, int order, const WeightedDirections& octant) {
  const WeightedDirections all = mirror_octant(octant);
  return DirectionSet(name, order, all.directions, all.weights);
}

/// Gauss-Legendre levels of the cosine about z; `azimuths(k)` gives the azimuths per quadrant on the k-th
/// level from the pole, k = 1 ... order/2.
template <class Azimuths>
DirectionSet on_gauss_levels(const char* name, int order, Azimuths azimuths) {
  const GaussRule levels = gauss_legendre(order);
  WeightedDirections octant;
  for (int k = 1; k <= order / 2; ++k) {
    const std::size_t level = static_cast<std::size_t>(order - k);
    append_level(octant, levels.nodes[level], levels.weights[level], azimuths(k));
  }
  return mirrored_set(name, order, octant);
}

}  // namespace

DirectionSet directions_product(int order) {
  return on_gauss_levels("product", order, [order](int) { return order / 2; });
}

DirectionSet directions_triangular(int order) {
  return on_gauss_levels("triangular", order, [](int k) { return k; });
}

DirectionSet directions_double_gauss(int order) {
  const GaussRule levels = gauss_legendre(order);  // on [-1, 1], moved to [0, 1]
  WeightedDirections octant;
  for (std::size_t level = 0; level < levels.nodes.size(); ++level)
    append_level(octant, (1 + levels.nodes[level]) / 2, levels.weights[level] / 2, order);
  return mirrored_set("double-gauss", order, octant);
}

}  // namespace etendue
