// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/half_width.h"

#include <cmath>
#include <numbers>

namespace etendue {
namespace {

/// Angles at which a phase function is sampled, from 1e-4 rad on, each larger by this factor.
constexpr double first_angle = 1e-4, angle_ratio = 1.02;

}  // namespace

double half_width(const PhaseFunction& phase) {
  const double forward = phase_value(phase, 1);
  for (double angle = first_angle; angle < std::numbers::pi; angle *= angle_ratio)
    if (phase_value(phase, std::cos(angle)) < forward / 2) return angle;
  return std::numbers::pi;
}

}  // namespace etendue
