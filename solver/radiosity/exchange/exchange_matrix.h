// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/radiosity/exchange/exchange.h"

namespace etendue {

/// Bytes up to which a matrix is kept; larger ones are made anew whenever they are applied.
inline constexpr std::size_t largest_kept_matrix = std::size_t{4} << 30;

/// All pairs of patches. Unoccluded ones by contour integrals, others times the share that rays see.
class ExchangeMatrix : public Exchange {
 public:
  /// The patches must outlive it.
  ExchangeMatrix(const std::vector<FlatPatch>& patches, int rays, int threads,
                 std::size_t largest_kept = largest_kept_matrix, const FactorProgress& progress = {});
  /// Of exchange areas that are known, [patch][patch].
  ExchangeMatrix(const std::vector<FlatPatch>& patches, std::vector<double> values);

  bool is_kept() const { return !values_.empty(); }
  double value(std::size_t j, std::size_t k) const { return scale(j) * scale(k) * found(j, k); }

  /// Bytes that one of so many patches takes.
  static std::size_t bytes_of(std::size_t patches) { return patches * patches * sizeof(double); }

 private:
  void fill(const FactorProgress& progress);
  double computed(std::size_t j, std::size_t k) const;
  double found(std::size_t j, std::size_t k) const {
    return is_kept() ? values_[j * size() + k] : computed(j, k);
  }
  std::vector<double> found_row(std::size_t j) const override;
  std::vector<double> found_times(std::span<const double> x, std::size_t bands) const override;

  std::vector<double> values_;  ///< [patch][patch] before scaling; empty: too large
};

}  // namespace etendue
