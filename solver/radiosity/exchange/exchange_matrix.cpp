// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange/exchange_matrix.h"

#include <algorithm>

#include "solver/radiosity/form_factors/exchange_area.h"

namespace etendue {
ExchangeMatrix::ExchangeMatrix(const std::vector<FlatPatch>& patches, int rays, int threads,
                               std::size_t largest_kept, const FactorProgress& progress)
    : Exchange(patches, rays, threads) {
  if (bytes_of(size()) <= largest_kept) fill(progress);
}

ExchangeMatrix::ExchangeMatrix(const std::vector<FlatPatch>& patches, std::vector<double> values)
    : Exchange(patches, 1, 1), values_(std::move(values)) {}

void ExchangeMatrix::fill(const FactorProgress& progress) {
  const std::size_t n = size(), step = n / progress_steps + 1;
  values_.assign(n * n, 0);
  for (std::size_t begin = 0; begin < n; begin += step) {
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads())
    for (std::size_t j = begin; j < std::min(n, begin + step); ++j)
      for (std::size_t k = j + 1; k < n; ++k) values_[k * n + j] = values_[j * n + k] = computed(j, k);
    const double left = 1 - static_cast<double>(std::min(n, begin + step)) / static_cast<double>(n);
    if (progress) progress(1 - left * left);
  }
}

double ExchangeMatrix::computed(std::size_t j, std::size_t k) const {
  if (j == k) return 0;
  const double free = exchange_area(patches()[std::min(j, k)], patches()[std::max(j, k)]);
  return free > 0 ? free * visibility().share(j, k) : 0;
}

std::vector<double> ExchangeMatrix::found_row(std::size_t j) const {
  std::vector<double> result(size());
#pragma omp parallel for schedule(static) num_threads(threads()) if (!is_kept())
  for (std::size_t k = 0; k < size(); ++k) result[k] = found(j, k);
  return result;
}

std::vector<double> ExchangeMatrix::found_times(std::span<const double> x, std::size_t bands) const {
  std::vector<double> result(x.size(), 0);
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads())
  for (std::size_t j = 0; j < size(); ++j) {
    double* sum = result.data() + j * bands;
    for (std::size_t k = 0; k < size(); ++k) {
      const double g = found(j, k);
      for (std::size_t b = 0; b < bands; ++b) sum[b] += g * x[k * bands + b];
    }
  }
  return result;
}

}  // namespace etendue
