// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/problem/problem.h"

namespace etendue {

/// Origin of one value of a medium or wall: `key` is `media.NAME.what` or `walls.NAME.what`.
Origin origin_of(const Medium& medium, const std::string& what);
Origin origin_of(const Wall& wall, const std::string& what);

/// Where a coefficient came from, and its band.
struct CoefficientPlace {
  Origin origin;
  std::string band;
};
/// Returns whether a coefficient is finite and not negative in a cell, else adds the fault.
bool check_sample(const CoefficientPlace& place, const Coefficient& coefficient, const CellSample& sample,
                  std::vector<Fault>& faults);

/// Faults of the asymmetries: -1 < g < 1.
void check_phase(const Medium& medium, const Bands& bands, std::vector<Fault>& faults);

/// Faults of a wall: radiance and reflectances not negative; reflectances, transmittance and the albedo of
/// what is glossy at most 1 together at every angle.
void check_wall(const Wall& wall, const Bands& bands, std::vector<Fault>& faults);

/// Faults of transmittance: on walls that are no sheets, or that differs between the two sides of one, which
/// would make light of nothing (by reciprocity both ways of light are alike).
void check_sheets(const Problem& problem, std::vector<Fault>& faults);

/// Faults of bands in which something emits, nothing absorbs and every wall reflects fully.
void check_steady_state(const Problem& problem, std::vector<Fault>& faults);

}  // namespace etendue
