// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "solver/radiosity/patch_visibility.h"

namespace etendue {

/// Bytes up to which a matrix is kept; larger ones are made anew whenever they are applied.
inline constexpr std::size_t largest_kept_matrix = std::size_t{4} << 30;

/// Is told which part of form factors is made, 0 to 1.
using FactorProgress = std::function<void(double)>;

/// The exchange areas G_jk = A_j F_jk of patches [length^2]: symmetric, which is the reciprocity of form
/// factors. Unoccluded pairs by contour integrals, others times the share that rays see.
class ExchangeMatrix {
 public:
  /// The patches must outlive it.
  ExchangeMatrix(const std::vector<FlatPatch>& patches, int rays, int threads,
                 std::size_t largest_kept = largest_kept_matrix, const FactorProgress& progress = {});
  /// Of exchange areas that are known, [patch][patch].
  ExchangeMatrix(const std::vector<FlatPatch>& patches, std::vector<double> values);

  std::size_t size() const { return patches_.size(); }
  const std::vector<FlatPatch>& patches() const { return patches_; }
  const PatchVisibility& visibility() const { return visibility_; }
  bool is_kept() const { return !values_.empty(); }
  int threads() const { return threads_; }

  double value(std::size_t j, std::size_t k) const;
  std::vector<double> row(std::size_t j) const;
  /// Its product with [patch][band].
  std::vector<double> times(std::span<const double> x, std::size_t bands) const;
  /// Largest and root mean square |sum of F_jk over k - 1| over the patches of closed walls.
  struct RowSums {
    double largest = 0, root_mean_square = 0;
  };
  RowSums row_sums() const;
  /// Replaces G by D G D with the diagonal D that makes all rows sum to one: symmetric as before (Sinkhorn
  /// 1964). Returns how many passes that took.
  int close(double tolerance);

  /// Bytes that one of so many patches takes.
  static std::size_t bytes_of(std::size_t patches) { return patches * patches * sizeof(double); }

 private:
  void fill(const FactorProgress& progress);
  double computed(std::size_t j, std::size_t k) const;
  double scaled(std::size_t j, std::size_t k, double value) const { return scale_[j] * scale_[k] * value; }

  const std::vector<FlatPatch>& patches_;
  PatchVisibility visibility_;
  int threads_;
  std::vector<double> values_;  ///< [patch][patch] before scaling; empty: too large
  std::vector<double> scale_;   ///< [patch] diagonal of D
};

}  // namespace etendue
