// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "solver/radiosity/exchange/patch_visibility.h"

namespace etendue {

/// Receives the part of the form factors that is made, 0 to 1.
using FactorProgress = std::function<void(double)>;
/// Parts of a loop over patches or cells after each of which progress is reported.
inline constexpr std::size_t progress_steps = 100;
/// Passes after which closing gives up: it gains about a digit in each.
inline constexpr int most_closing_passes = 100;

/// The exchange areas G_jk = A_j F_jk of patches [length^2]: symmetric, which is the reciprocity of form
/// factors.
class Exchange {
 public:
  virtual ~Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  std::size_t size() const { return patches_.size(); }
  const std::vector<FlatPatch>& patches() const { return patches_; }
  const PatchVisibility& visibility() const { return visibility_; }
  int threads() const { return threads_; }

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

 protected:
  /// The patches must outlive it.
  Exchange(const std::vector<FlatPatch>& patches, int rays, int threads);

  double scale(std::size_t j) const { return scale_[j]; }
  /// Undoes close(), for factors that have changed.
  void reopen() { scale_.assign(scale_.size(), 1); }

 private:
  // Before it is scaled.
  virtual std::vector<double> found_row(std::size_t j) const = 0;
  virtual std::vector<double> found_times(std::span<const double> x, std::size_t bands) const = 0;

  const std::vector<FlatPatch>& patches_;
  PatchVisibility visibility_;
  int threads_;
  std::vector<double> scale_;  ///< [patch] diagonal of D
};

}  // namespace etendue
