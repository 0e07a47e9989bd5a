// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange_matrix.h"

#include <algorithm>
#include <cmath>

#include "solver/radiosity/exchange_area.h"

namespace etendue {
namespace {

// Passes after which closing gives up: it gains about a digit in each.
constexpr int most_closing_passes = 100;
// Parts of the rows after each of which progress is told.
constexpr std::size_t progress_steps = 100;

}  // namespace

ExchangeMatrix::ExchangeMatrix(const std::vector<FlatPatch>& patches, int rays, int threads,
                               std::size_t largest_kept, const FactorProgress& progress)
    : patches_(patches), visibility_(patches, rays, threads), threads_(threads), scale_(patches.size(), 1) {
  if (bytes_of(size()) <= largest_kept) fill(progress);
}

void ExchangeMatrix::fill(const FactorProgress& progress) {
  const std::size_t n = size(), step = n / progress_steps + 1;
  values_.assign(n * n, 0);
  for (std::size_t begin = 0; begin < n; begin += step) {
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads_)
    for (std::size_t j = begin; j < std::min(n, begin + step); ++j)
      for (std::size_t k = j + 1; k < n; ++k) values_[k * n + j] = values_[j * n + k] = computed(j, k);
    const double left = 1 - static_cast<double>(std::min(n, begin + step)) / static_cast<double>(n);
    if (progress) progress(1 - left * left);
  }
}

ExchangeMatrix::ExchangeMatrix(const std::vector<FlatPatch>& patches, std::vector<double> values)
    : patches_(patches),
      visibility_(patches, 1, 1),
      threads_(1),
      values_(std::move(values)),
      scale_(patches.size(), 1) {}

double ExchangeMatrix::computed(std::size_t j, std::size_t k) const {
  if (j == k) return 0;
  const double free = exchange_area(patches_[std::min(j, k)], patches_[std::max(j, k)]);
  return free > 0 ? free * visibility_.share(j, k) : 0;
}

double ExchangeMatrix::value(std::size_t j, std::size_t k) const {
  return scaled(j, k, is_kept() ? values_[j * size() + k] : computed(j, k));
}

std::vector<double> ExchangeMatrix::row(std::size_t j) const {
  std::vector<double> result(size());
#pragma omp parallel for schedule(static) num_threads(threads_) if (!is_kept())
  for (std::size_t k = 0; k < size(); ++k) result[k] = value(j, k);
  return result;
}

std::vector<double> ExchangeMatrix::times(std::span<const double> x, std::size_t bands) const {
  std::vector<double> result(x.size(), 0);
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads_)
  for (std::size_t j = 0; j < size(); ++j) {
    double* sum = result.data() + j * bands;
    for (std::size_t k = 0; k < size(); ++k) {
      const double g = value(j, k);
      for (std::size_t b = 0; b < bands; ++b) sum[b] += g * x[k * bands + b];
    }
  }
  return result;
}

ExchangeMatrix::RowSums ExchangeMatrix::row_sums() const {
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
int ExchangeMatrix::close(double tolerance) {
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
