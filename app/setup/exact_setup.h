// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "solver/exact/exact_input.h"

namespace etendue {

/// The exact radiance of a case with [exact], and the source and inflow that belong to it.
struct ExactSetup {
  ExactRadiance radiance;
  ExactInput input;

  /// The arguments must outlive it. Throws InputError with the line of the formula.
  ExactSetup(const Case& given, const Problem& problem, const DirectionSet& directions);
};

}  // namespace etendue
