// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/angular_history.h"

#include <numeric>
#include <utility>

namespace etendue {

std::vector<int> all_ordinates(const DirectionSet& directions) {
  std::vector<int> all(static_cast<std::size_t>(directions.count()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<double> AngularHistory::begin(const DirectionSet& directions) {
  const auto cells = static_cast<std::size_t>(mesh_.cell_count());
  const std::size_t length = 4 * bands_;
  std::vector<double> fluence(cells * length, 0);
  last_.clear();
  if (!sources_.has_pulses()) return fluence;
  for (int m = 0; m < directions.count(); ++m) {
    const OrdinateIndex ordinate(m);
    std::vector<double> values(cells * length, 0);
    for (std::size_t c = 0; c < cells; ++c) {
      const CellIndex cell(static_cast<std::int64_t>(c));
      const std::span<double> own = std::span<double>(values).subspan(c * length, length);
      sources_.add_pulses(ordinate, cell, own);
      for (std::size_t i = 0; i < length; ++i) {
        own[i] /= slowness_[static_cast<std::size_t>(mesh_.region(cell))];
        fluence[c * length + i] += directions.weight(ordinate) * own[i];
      }
    }
    last_.push_back({m, std::move(values)});
  }
  return fluence;
}

void AngularHistory::accept(std::vector<OrdinateRadiance> radiance, bool keeps_before) {
  if (keeps_before)
    other_ = std::move(last_);
  else
    other_.clear();
  last_ = std::move(radiance);
}

void AngularHistory::add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  sources_.add_source(factors_, m, cell, values);
  const double by_time = slowness_[static_cast<std::size_t>(mesh_.region(cell))] / stage_;
  const auto add = [&](const std::vector<OrdinateRadiance>& radiance, double factor) {
    if (radiance.empty() || factor == 0) return;
    const double* own = radiance[m.at()].values.data() + cell.at() * values.size();
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += factor * by_time * own[i];
  };
  add(last_, of_last_);
  add(other_, of_other_);
}

}  // namespace etendue
