// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/adjoint/chosen_response.h"
#include "app/adjoint/gradient_tables.h"
#include "solver/adjoint/solve_adjoint.h"
#include "solver/problem/bands.h"

namespace etendue {

/// A response with its solution.
struct SolvedResponse {
  ChosenResponse response;
  AdjointSolution solution;
  std::optional<Gradient> gradient = {};
  std::vector<Derivative> derivatives = {};
};

/// response,quantity,unit,kind,emitter,band,uncollided,collided,total,share: what each emitter brings. The
/// last rows of a response, of kind "all", are the sums.
std::string importance_csv(const std::vector<SolvedResponse>& solved, const Bands& bands);

/// The same of one response for people; emitters that bring most come first.
std::string share_text(const SolvedResponse& solved, const Bands& bands);

}  // namespace etendue
