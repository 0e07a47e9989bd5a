// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/index.h"

namespace etendue {

/// Isotropic emission q of the cells in each band [power/(length^3 sr)], linear in each: the mean, and where
/// it differs within a cell its slope, the values at the vertices less the mean.
class CellEmission {
 public:
  CellEmission() = default;
  /// 0 everywhere.
  CellEmission(std::size_t cells, std::size_t bands) : bands_(bands), means_(cells * bands, 0) {}

  /// Adds to a cell in one band a mean and a slope, which sums to 0.
  void add(CellIndex cell, std::size_t band, double mean, const std::array<double, 4>& slope);

  /// Adds another one of the same cells and bands.
  void add(const CellEmission& other);
  bool empty() const { return means_.empty(); }

  std::span<const double> means() const { return means_; }  ///< [cell][band]
  double mean(CellIndex cell, std::size_t band) const { return means_[cell.at() * bands_ + band]; }
  /// At vertex i of a cell.
  double at(CellIndex cell, std::size_t band, std::size_t i) const {
    return mean(cell, band) + slope(cell, band, i);
  }
  double slope(CellIndex cell, std::size_t band, std::size_t i) const {
    if (rows_.empty() || rows_[cell.at()] < 0) return 0;
    return slopes_[(static_cast<std::size_t>(rows_[cell.at()]) * 4 + i) * bands_ + band];
  }
  /// Whether it differs within a cell in any band.
  bool varies_in(CellIndex cell) const { return !rows_.empty() && rows_[cell.at()] >= 0; }
  /// The same in some bands alone, in this order.
  CellEmission of_bands(std::span<const int> bands) const;

 private:
  std::size_t bands_ = 0;
  std::vector<double> means_;       ///< [cell][band]
  std::vector<std::int32_t> rows_;  ///< [cell] row of the slopes, -1: none; empty: none anywhere
  std::vector<double> slopes_;      ///< [row][4][band]
};

}  // namespace etendue
