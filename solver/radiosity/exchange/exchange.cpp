// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange/exchange.h"

#include <algorithm>
#include <cmath>

namespace etendue {
Exchange::Exchange(const std::vector<FlatPatch>& patches, int rays, int threads)
    : patches_(patches), visibility_(patches, rays, threads), threads_(threads), scale_(patches.size(), 1) {}

std::vector<double> Exchange::row(std::size_t j) const {
  std::vector<double> result = found_row(j);
  for (std::size_t k = 0; k < size(); ++k) result[k] *= scale_[j] * scale_[k];
  return result;
}

std::vector<double> Exchange::times(std::span<const double> x, std::size_t bands) const {
  std::vector<double> scaled(x.begin(), x.end());
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] *= scale_[i / bands];
  std::vector<double> result = found_times(scaled, bands);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] *= scale_[i / bands];
  return result;
}

Exchange::RowSums Exchange::row_sums() const {
  const std::vector<double> sums = times(std::vector<double>(size(), 1.0), 1);
  RowSums found;
  for (std::size_t j = 0; j < size(); ++j) {
    const double error = std::abs(sums[j] / patches_[j].area() - 1);
    found.largest = std::max(found.largest, error);
    found.root_mean_square += error * error;
  }
  found.root_mean_square = std::sqrt(found.root_mean_square / static_cast<double>(size()));
  return found;
}

// d_j = sqrt(d_j A_j / (G d)_j) is a fixed point where d_j (G d)_j = A_j; the root keeps it from swinging.
int Exchange::close(double tolerance) {
  for (int pass = 1; pass <= most_closing_passes; ++pass) {
    const std::vector<double> sums = times(std::vector<double>(size(), 1.0), 1);
    double worst = 0;
    for (std::size_t j = 0; j < size(); ++j) {
      if (sums[j] <= 0) continue;
      const double ratio = patches_[j].area() / sums[j];
      worst = std::max(worst, std::abs(ratio - 1));
      scale_[j] *= std::sqrt(ratio);
    }
    if (worst <= tolerance) return pass;
  }
  return most_closing_passes;
}

}  // namespace etendue
