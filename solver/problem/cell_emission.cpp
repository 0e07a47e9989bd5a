// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/cell_emission.h"

#include <algorithm>

#include "solver/problem/band_selection.h"

namespace etendue {

void CellEmission::add(CellIndex cell, std::size_t band, double mean, const std::array<double, 4>& slope) {
  means_[cell.at() * bands_ + band] += mean;
  if (std::ranges::all_of(slope, [](double value) { return value == 0; })) return;
  if (rows_.empty()) rows_.assign(means_.size() / bands_, -1);
  std::int32_t& row = rows_[cell.at()];
  if (row < 0) {
    row = static_cast<std::int32_t>(slopes_.size() / (4 * bands_));
    slopes_.resize(slopes_.size() + 4 * bands_, 0);
  }
  for (std::size_t i = 0; i < slope.size(); ++i)
    slopes_[(static_cast<std::size_t>(row) * 4 + i) * bands_ + band] += slope[i];
}

void CellEmission::add(const CellEmission& other) {
  for (std::size_t i = 0; i < means_.size(); ++i) {
    const CellIndex cell(static_cast<std::int32_t>(i / bands_));
    const std::size_t band = i % bands_;
    std::array<double, 4> slope = {};
    for (std::size_t k = 0; k < slope.size(); ++k) slope[k] = other.slope(cell, band, k);
    add(cell, band, other.mean(cell, band), slope);
  }
}

CellEmission CellEmission::of_bands(std::span<const int> bands) const {
  CellEmission result = *this;
  if (empty()) return result;
  result.bands_ = bands.size();
  result.means_ = select_bands(std::span<const double>(means_), bands_, bands);
  result.slopes_ = select_bands(std::span<const double>(slopes_), bands_, bands);
  return result;
}

}  // namespace etendue
