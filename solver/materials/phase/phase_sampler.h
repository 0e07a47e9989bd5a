// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/materials/phase/phase_function.h"

namespace etendue {

/// Draws cosines of the angle of deflection: a uniform number u in [0, 1) becomes the cosine below which a
/// share u of the light is scattered. In the plane the side to which light turns is left to the caller.
/// Isotropic scattering and Henyey and Greenstein's functions are inverted in closed form; others by a table
/// in the angle, as fine as their moments ask, between whose nodes the density is linear.
class PhaseSampler {
 public:
  explicit PhaseSampler(const PhaseFunction& phase);
  double cosine(double u) const;

 private:
  PhaseFunction phase_;
  std::vector<double> density_;     ///< [node] per angle, from pi down to 0
  std::vector<double> cumulative_;  ///< [node] from 0 to 1
};

}  // namespace etendue
