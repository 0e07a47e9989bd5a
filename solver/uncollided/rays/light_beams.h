// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Where a beam begins: evenly over a length behind a distance [length].
struct BeamWay {
  double distance = 0, length = 0;
};

/// The uncollided radiance at a point as thin beams: the direction in which the light travels, and the
/// fluence [band] that it brings [power/length^2], from somewhere on its way (at 0 where nobody asks).
class LightBeams {
 public:
  explicit LightBeams(std::size_t bands) : bands_(bands) {}

  void clear() {
    directions_.clear();
    ways_.clear();
    fluence_.clear();
  }
  /// The fluence of the new beam, to be filled in.
  std::span<double> add(const Vec3& direction, BeamWay way = {}) {
    directions_.push_back(direction);
    ways_.push_back(way);
    fluence_.resize(directions_.size() * bands_, 0);
    return std::span(fluence_).last(bands_);
  }
  /// Takes the last one back.
  void drop() {
    directions_.pop_back();
    ways_.pop_back();
    fluence_.resize(directions_.size() * bands_);
  }

  std::size_t bands() const { return bands_; }
  std::size_t size() const { return directions_.size(); }
  const Vec3& direction(std::size_t i) const { return directions_[i]; }
  const BeamWay& way(std::size_t i) const { return ways_[i]; }
  std::span<const double> fluence(std::size_t i) const {
    return std::span(fluence_).subspan(i * bands_, bands_);
  }

 private:
  std::size_t bands_;
  std::vector<Vec3> directions_;
  std::vector<BeamWay> ways_;
  std::vector<double> fluence_;  ///< [beam][band]
};

}  // namespace etendue
