// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/extended/sparse_rows.h"

#include <limits>

namespace etendue {

void SparseRows::add_row(std::span<const std::uint32_t> columns, std::span<const float> values) {
  column_.insert(column_.end(), columns.begin(), columns.end());
  value_.insert(value_.end(), values.begin(), values.end());
  begin_.push_back(column_.size());
}

SparseRows SparseRows::transposed() const {
  SparseRows result(stored_);
  result.begin_.assign(rows() + 1, 0);
  for (const std::uint32_t c : column_) ++result.begin_[c + 1];
  for (std::size_t r = 0; r < rows(); ++r) result.begin_[r + 1] += result.begin_[r];
  result.column_.resize(entries());
  result.value_.resize(value_.size());
  std::vector<std::size_t> next(result.begin_.begin(), result.begin_.end() - 1);
  for (std::size_t r = 0; r < rows(); ++r)
    for (std::size_t e = begin_[r]; e < begin_[r + 1]; ++e) {
      const std::size_t to = next[column_[e]]++;
      result.column_[to] = static_cast<std::uint32_t>(r);
      for (std::size_t b = 0; b < stored_; ++b) result.value_[to * stored_ + b] = value_[e * stored_ + b];
    }
  return result;
}

SparseRows SparseRows::half_sum(const SparseRows& rows, const SparseRows& to_transpose) {
  const SparseRows other = to_transpose.transposed();
  const std::size_t stored = rows.stored_;
  SparseRows result(stored);
  std::vector<std::uint32_t> columns;
  std::vector<float> values;
  for (std::size_t r = 0; r < rows.rows(); ++r) {
    columns.clear();
    values.clear();
    std::size_t a = rows.begin_[r], b = other.begin_[r];
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    while (a < rows.begin_[r + 1] || b < other.begin_[r + 1]) {
      const std::uint32_t left = a < rows.begin_[r + 1] ? rows.column_[a] : none,
                          right = b < other.begin_[r + 1] ? other.column_[b] : none;
      columns.push_back(std::min(left, right));
      for (std::size_t i = 0; i < stored; ++i)
        values.push_back(((left <= right ? rows.value_[a * stored + i] : 0.0F) +
                          (right <= left ? other.value_[b * stored + i] : 0.0F)) /
                         2);
      if (left <= right) ++a;
      if (right <= left) ++b;
    }
    result.add_row(columns, values);
  }
  return result;
}

void SparseRows::add_product(std::span<const double> x, std::size_t bands, std::span<double> y,
                             int threads) const {
#pragma omp parallel for schedule(dynamic, 16) num_threads(threads)
  for (std::size_t r = 0; r < rows(); ++r)
    for (std::size_t e = begin_[r]; e < begin_[r + 1]; ++e)
      for (std::size_t b = 0; b < bands; ++b) y[r * bands + b] += at(e, b) * x[column_[e] * bands + b];
}

void SparseRows::add_transposed_product(std::span<const double> x, std::size_t bands,
                                        std::span<double> y) const {
  for (std::size_t r = 0; r < rows(); ++r)
    for (std::size_t e = begin_[r]; e < begin_[r + 1]; ++e)
      for (std::size_t b = 0; b < bands; ++b) y[column_[e] * bands + b] += at(e, b) * x[r * bands + b];
}

void SparseRows::add_row_to(std::size_t row, std::size_t bands, std::span<double> y) const {
  for (std::size_t e = begin_[row]; e < begin_[row + 1]; ++e)
    for (std::size_t b = 0; b < bands; ++b) y[column_[e] * bands + b] += at(e, b);
}

}  // namespace etendue
