// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace etendue {

/// Light that arrives at a few points, [point][band]: zero in all bands where something is in between.
class ArrivingLight {
 public:
  explicit ArrivingLight(std::size_t bands) : bands_(bands) {}

  void clear() { values_.clear(); }
  /// Those of one more point, zero at first.
  std::span<double> add() {
    values_.resize(values_.size() + bands_, 0);
    return std::span(values_).last(bands_);
  }
  std::size_t size() const { return values_.size() / bands_; }
  std::span<double> at(std::size_t point) { return std::span(values_).subspan(point * bands_, bands_); }

  bool is_dark(std::size_t point) const {
    return std::ranges::all_of(std::span(values_).subspan(point * bands_, bands_),
                               [](double value) { return value == 0; });
  }
  std::size_t lit() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < size(); ++i) count += is_dark(i) ? 0 : 1;
    return count;
  }
  /// Returns whether no point has more than a trifle [band].
  bool is_trifle(std::span<const double> trifle) const {
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (values_[i] > trifle[i % bands_]) return false;
    return true;
  }
  /// Returns whether the points that are not in the dark have as much in each band, within a factor, or not
  /// more than a trifle [band].
  bool is_even(double factor, std::span<const double> trifle) const {
    for (std::size_t b = 0; b < bands_; ++b) {
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (std::size_t i = 0; i < size(); ++i) {
        if (is_dark(i)) continue;
        least = std::min(least, values_[i * bands_ + b]);
        most = std::max(most, values_[i * bands_ + b]);
      }
      if (most > trifle[b] && most > factor * least) return false;
    }
    return true;
  }

 private:
  std::size_t bands_;
  std::vector<double> values_;
};

}  // namespace etendue
