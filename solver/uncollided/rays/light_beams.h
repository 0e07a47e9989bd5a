// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Interval of a ray in which its light is emitted uniformly: a length behind a distance [length].
struct EmissionInterval {
  double distance = 0, length = 0;
};

/// The uncollided radiance at a point as thin beams: the direction in which the light travels, and the
/// fluence [band] that it brings [power/length^2], from an interval of its path (at 0 where it is not
/// needed).
class LightBeams {
 public:
  explicit LightBeams(std::size_t bands) : bands_(bands) {}

  void clear() {
    directions_.clear();
    intervals_.clear();
    fluence_.clear();
  }
  /// The fluence of the new beam, to be filled in.
  std::span<double> add(const Vec3& direction, EmissionInterval interval = {}) {
    directions_.push_back(direction);
    intervals_.push_back(interval);
    fluence_.resize(directions_.size() * bands_, 0);
    return std::span(fluence_).last(bands_);
  }
  /// Takes the last one back.
  void drop() {
    directions_.pop_back();
    intervals_.pop_back();
    fluence_.resize(directions_.size() * bands_);
  }

  std::size_t bands() const { return bands_; }
  std::size_t size() const { return directions_.size(); }
  const Vec3& direction(std::size_t i) const { return directions_[i]; }
  const EmissionInterval& interval(std::size_t i) const { return intervals_[i]; }
  std::span<const double> fluence(std::size_t i) const {
    return std::span(fluence_).subspan(i * bands_, bands_);
  }

 private:
  std::size_t bands_;
  std::vector<Vec3> directions_;
  std::vector<EmissionInterval> intervals_;
  std::vector<double> fluence_;  ///< [beam][band]
};

}  // namespace etendue
