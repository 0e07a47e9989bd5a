// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// For the kernel files only.
#include <cstring>

#include "solver/transport/kernel/kernel_inline.h"
#include "solver/transport/kernel/sweep_kernel.h"

namespace etendue {
namespace {

/// Sums that fill the registers of the instruction set: rows times columns of W numbers.
#ifdef __AVX512F__
constexpr int product_rows = 8, product_columns = 2;
#else
constexpr int product_rows = 4, product_columns = 1;
#endif
/// Numbers of one column that no instruction set keeps in more than two registers.
#ifdef __AVX__
constexpr int product_width = 8;
#else
constexpr int product_width = 4;
#endif

/// In double precision in all kernel files.
typedef double ProductLanes __attribute__((vector_size(product_width * sizeof(double))));

/// Rows first … first + Rows - 1, and columns from `at` on.
template <int Rows>
ETENDUE_KERNEL_INLINE void product_block(const ProductTask& task, int first, std::size_t at) {
  ProductLanes sum[Rows][product_columns] = {};
  const double* matrix = task.matrix + static_cast<std::ptrdiff_t>(first) * task.inner;
  for (std::ptrdiff_t k = 0; k < task.inner; ++k) {
    const double* factor = task.factor + static_cast<std::size_t>(k) * product_lanes + at;
    for (int c = 0; c < product_columns; ++c) {
      ProductLanes column;
      std::memcpy(&column, factor + c * product_width, sizeof column);
      for (int r = 0; r < Rows; ++r) sum[r][c] += matrix[r * task.inner + k] * column;
    }
  }
  for (int r = 0; r < Rows; ++r)
    for (int c = 0; c < product_columns; ++c)
      std::memcpy(task.result + static_cast<std::size_t>(first + r) * product_lanes + at + c * product_width,
                  &sum[r][c], sizeof sum[r][c]);
}

void matrix_product(const ProductTask& task) {
  int row = 0;
  for (; row + product_rows <= task.rows; row += product_rows)
    for (std::size_t at = 0; at < product_lanes; at += product_width * product_columns)
      product_block<product_rows>(task, row, at);
  for (; row < task.rows; ++row)
    for (std::size_t at = 0; at < product_lanes; at += product_width * product_columns)
      product_block<1>(task, row, at);
}

}  // namespace
}  // namespace etendue
