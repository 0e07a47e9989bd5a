// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace etendue {

/// Means and their standard errors from batches of histories that are independent of each other. With v_i the
/// estimate from the n_i histories of batch i, N = sum of n_i and M batches,
///
///     v = sum of n_i v_i / N,     error^2 = sum of n_i (v_i - v)^2 / ((M - 1) N),
///
/// which holds for batches of different size too, since the variance of v_i goes as 1/n_i.
class BatchStatistics {
 public:
  /// Adds a batch; all batches have the same number of values.
  void add(std::span<const double> values, double histories);

  std::vector<double> means() const;
  std::vector<double> errors() const;  ///< infinite for a single batch
  double error(std::size_t i) const;
  double mean(std::size_t i) const { return histories_ > 0 ? first_[i] / histories_ : 0; }

  std::size_t size() const { return first_.size(); }
  int batches() const { return batches_; }
  double histories() const { return histories_; }

  /// All of it as numbers, and back; empty where there was no batch.
  std::vector<double> packed() const;
  static BatchStatistics unpacked(std::span<const double> numbers);

 private:
  int batches_ = 0;
  double histories_ = 0;
  std::vector<double> first_;   ///< sum of n_i v_i
  std::vector<double> second_;  ///< sum of n_i v_i^2
};

}  // namespace etendue
