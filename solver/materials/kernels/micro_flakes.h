// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/materials/kernels/directional_scattering.h"

namespace etendue {

/// The projected area of flakes along a direction, sqrt(w^T S w), and its mean over all directions.
double flake_projection(const MicroFlakes& flakes, const Vec3& direction);
double mean_flake_projection(const MicroFlakes& flakes);

/// Mirrors: k(before -> after) = albedo D(h)/4 for a density of 1 [1/sr], h half way between `after` and
/// -`before`, and D the SGGX distribution 1/(pi sqrt|S| (h^T S^-1 h)^2) (Heitz et al. 2015, equations 10 and
/// 12). Not for after = before, where h may be any normal that is seen edge on.
double flake_value(const MicroFlakes& flakes, const Vec3& before, const Vec3& after);

/// The integral of D(h)/4 (1 - w.v) over v for flakes of albedo 1: the momentum that a direction w loses to
/// mirrors, up to twice the projected area where faces are seen.
double flake_momentum_transfer(const MicroFlakes& flakes, const Vec3& direction);

}  // namespace etendue
