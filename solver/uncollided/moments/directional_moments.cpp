// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/moments/directional_moments.h"

namespace etendue {
namespace {

constexpr std::size_t first_table = 32;

std::size_t hash(std::int32_t direction) { return static_cast<std::size_t>(direction) * 2654435761U; }

}  // namespace

void DirectionalMoments::clear() {
  found_.clear();
  values_.clear();
  table_.assign(first_table, -1);
  aimed_ = false;
}

void DirectionalMoments::grow() {
  table_.assign(2 * table_.size(), -1);
  for (std::size_t place = 0; place < found_.size(); ++place) {
    std::size_t at = hash(found_[place]) % table_.size();
    while (table_[at] >= 0) at = (at + 1) % table_.size();
    table_[at] = static_cast<std::int32_t>(place);
  }
}

std::size_t DirectionalMoments::place_of(std::int32_t direction) {
  std::size_t at = hash(direction) % table_.size();
  for (; table_[at] >= 0; at = (at + 1) % table_.size())
    if (found_[static_cast<std::size_t>(table_[at])] == direction)
      return static_cast<std::size_t>(table_[at]);
  table_[at] = static_cast<std::int32_t>(found_.size());
  found_.push_back(direction);
  values_.resize(values_.size() + 4 * bands_, 0);
  if (2 * found_.size() > table_.size()) grow();
  return found_.size() - 1;
}

void DirectionalMoments::add(const DirectionalMoments& other) {
  for (std::size_t k = 0; k < other.found_.size(); ++k) {
    const std::span<double> to = values(place_of(other.found_[k]));
    const std::span<const double> from = other.values(k);
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
  }
}

void DirectionalMoments::add(const Vec3& direction, std::span<const double> shape, std::size_t band,
                             double power) {
  if (power == 0) return;
  if (!aimed_ || direction != last_) {
    const OctahedralGrid::Weights weights = directions_->weights(direction, detail_);
    for (std::size_t v = 0; v < 3; ++v) {
      weight_[v] = weights.weight[v];
      if (weight_[v] != 0) aim_[v] = place_of(weights.point[v]);
    }
    last_ = direction;
    aimed_ = true;
  }
  for (std::size_t v = 0; v < 3; ++v) {
    if (weight_[v] == 0) continue;
    double* to = &values_[aim_[v] * 4 * bands_ + band];
    for (std::size_t i = 0; i < 4; ++i) to[i * bands_] += weight_[v] * power * shape[i];
  }
}

}  // namespace etendue
