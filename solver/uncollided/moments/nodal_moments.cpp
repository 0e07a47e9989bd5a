// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/moments/nodal_moments.h"

#include <cmath>

namespace etendue {

void NodalMoments::add(std::span<const double> shape, double measure, const Vec3& direction,
                       std::span<const double> fluence) {
  for (std::size_t i = 0; i < nodes_; ++i)
    for (std::size_t b = 0; b < bands_; ++b) {
      const double value = measure * shape[i] * fluence[b];
      at(i, 0, b) += value;
      for (std::size_t axis = 0; axis < 3; ++axis)
        at(i, 1 + axis, b) += value * direction[static_cast<Eigen::Index>(axis)];
    }
}

double NodalMoments::integral(std::size_t component, std::size_t band) const {
  double sum = 0;
  for (std::size_t i = 0; i < nodes_; ++i) sum += at(i, component, band);
  return sum;
}

double NodalMoments::size() const {
  double sum = 0;
  for (std::size_t b = 0; b < bands_; ++b) sum += std::abs(integral(0, b));
  return sum;
}

double NodalMoments::difference(const NodalMoments& other) const {
  double sum = 0;
  for (std::size_t b = 0; b < bands_; ++b) sum += std::abs(integral(0, b) - other.integral(0, b));
  return sum;
}

double NodalMoments::nodal(std::size_t node, std::size_t component, std::size_t band, double measure) const {
  const auto corners = static_cast<double>(nodes_);
  return corners / measure * ((corners + 1) * at(node, component, band) - integral(component, band));
}

}  // namespace etendue
