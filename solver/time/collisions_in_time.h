// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/time/uncollided_in_time.h"
#include "solver/uncollided/first_collision/first_collision.h"

namespace etendue {

/// Uncollided light as it changes, one factor for all bands, and its first collisions on a set of directions.
class CollisionsInTime {
 public:
  /// The arguments must outlive it.
  CollisionsInTime(const UncollidedInTime& uncollided, const DirectionSet& directions, int threads)
      : uncollided_(uncollided),
        values_(uncollided.at({1, 1, [](const PathTime&, std::span<double> factors) { factors[0] = 0; }})),
        input_(uncollided.lights(), values_.field, directions, threads) {}
  CollisionsInTime(const CollisionsInTime&) = delete;
  CollisionsInTime& operator=(const CollisionsInTime&) = delete;

  const UncollidedInTime& uncollided() const { return uncollided_; }
  void set(const DelayFactors& factors) { uncollided_.set(factors, values_); }
  const UncollidedValues& values() const { return values_; }
  const AngularInput& input() const { return input_; }

 private:
  const UncollidedInTime& uncollided_;
  UncollidedValues values_;
  FirstCollision input_;
};

}  // namespace etendue
