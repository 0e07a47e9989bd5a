// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include <Eigen/Core>

#include "solver/angular/harmonics/harmonics.h"
#include "solver/angular/sets/direction_set.h"

namespace etendue {

/// The harmonics of a direction set (DiscreteHarmonics) between its ordinates: those combinations of
/// spherical harmonics, in the plane of circular ones, up to the same degree that have their values on the
/// ordinates; of several the smallest.
class ContinuousHarmonics {
 public:
  ContinuousHarmonics(const DirectionSet& set, int degree);

  const DiscreteHarmonics& discrete() const { return discrete_; }
  int count() const { return discrete_.count(); }
  /// Their values [k] at any unit direction.
  void at(const Vec3& direction, std::span<double> values) const;

 private:
  AngularSpace space_;
  int degree_;
  DiscreteHarmonics discrete_;
  Eigen::MatrixXd combination_;  ///< [k, raw harmonic]
};

}  // namespace etendue
