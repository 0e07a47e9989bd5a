// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "solver/materials/phase/phase_part.h"
#include "solver/materials/phase/phase_plane.h"

namespace etendue {

/// Scatterers of several kinds: the sum of share p over the parts.
struct PhaseMixture {
  std::vector<double> shares;  ///< of the scattering coefficient; they sum to 1
  std::vector<PhasePart> parts;
  bool operator==(const PhaseMixture&) const = default;
};
double value_of(const PhaseMixture& phase, double mu);
double moment_of(const PhaseMixture& phase, int degree);
std::string name_of(const PhaseMixture& phase);

/// How light turns when it scatters; the integral over the sphere is 1, that of a PhasePlane over the circle.
using PhaseFunction =
    std::variant<PhaseIsotropic, PhaseRayleigh, PhaseHenyeyGreenstein, PhaseDoubleHenyeyGreenstein,
                 PhaseCornetteShanks, PhaseLegendre, PhaseTable, PhaseMixture, PhasePlane>;

/// The phase function of this model in the plane (itself if it is one already).
PhaseFunction in_plane(const PhaseFunction& phase);

/// Value at the cosine `mu` of the angle of deflection [1/sr], in the plane [1/rad].
double phase_value(const PhaseFunction& phase, double mu);

/// Legendre moment of degree l: the integral of p(mu) P_l(mu) over the sphere, in the plane that of p cos(l
/// t) over the circle; 1 for l = 0, g for l = 1.
double phase_moment(const PhaseFunction& phase, int degree);

/// The mean cosine g.
double phase_asymmetry(const PhaseFunction& phase);

std::string phase_name(const PhaseFunction& phase);

}  // namespace etendue
