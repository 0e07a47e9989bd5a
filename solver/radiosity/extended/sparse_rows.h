// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace etendue {

/// Sparse square matrices of one pattern, one for each band or one for all, row by row.
class SparseRows {
 public:
  /// `stored` is how many numbers an entry has: those of the bands, or one.
  explicit SparseRows(std::size_t stored) : stored_(stored) {}

  /// The next row; columns ascend, `values` are [entry][stored].
  void add_row(std::span<const std::uint32_t> columns, std::span<const float> values);
  /// (R + S^T)/2 of two of as many rows and numbers: of R with itself exactly symmetric.
  static SparseRows half_sum(const SparseRows& rows, const SparseRows& to_transpose);
  /// Replaces each number of a row, new = change(column, band stored, old).
  template <class Change>
  void change_row(std::size_t row, Change change) {
    for (std::size_t e = begin_[row]; e < begin_[row + 1]; ++e)
      for (std::size_t b = 0; b < stored_; ++b)
        value_[e * stored_ + b] = static_cast<float>(change(column_[e], b, at(e, b)));
  }

  std::size_t rows() const { return begin_.size() - 1; }
  std::size_t entries() const { return column_.size(); }
  std::size_t entries_of(std::size_t row) const { return begin_[row + 1] - begin_[row]; }
  /// Adds R x to y, both [row][band].
  void add_product(std::span<const double> x, std::size_t bands, std::span<double> y, int threads) const;
  /// Adds R^T x.
  void add_transposed_product(std::span<const double> x, std::size_t bands, std::span<double> y) const;
  /// Adds a row to y, [row][band].
  void add_row_to(std::size_t row, std::size_t bands, std::span<double> y) const;

  /// Bytes of an entry.
  static std::size_t bytes_of(std::size_t stored) { return sizeof(std::uint32_t) + stored * sizeof(float); }

 private:
  /// R^T, its columns ascending too.
  SparseRows transposed() const;
  double at(std::size_t entry, std::size_t band) const {
    return static_cast<double>(value_[stored_ == 1 ? entry : entry * stored_ + band]);
  }

  std::size_t stored_;
  std::vector<std::size_t> begin_{0};  ///< [row and one more]
  std::vector<std::uint32_t> column_;
  std::vector<float> value_;  ///< [entry][stored]
};

}  // namespace etendue
