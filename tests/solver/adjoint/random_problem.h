// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/adjoint/response.h"
#include "solver/adjoint/solve_adjoint.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"

namespace etendue {

/// How the lights of a random problem shine before their first collision.
enum class Rays {
  none,       ///< all on the ordinates
  from_lamp,  ///< one point light along rays
  from_all    ///< a point light and a beam along rays
};

/// A mesh of the unit cube, such as two_region_mesh, filled at random: media of three unlike bands that
/// absorb, scatter and emit, thin and thick, in one band by a formula; walls that emit, reflect diffusely, as
/// mirrors and with a lobe; two lamps and a beam.
/// `change` may change them.
Problem random_problem(const TetrahedralMesh& mesh, unsigned seed, Rays rays,
                       const std::function<void(std::vector<Medium>&, std::vector<Wall>&)>& change = {});

/// A response of each kind at random places of that mesh.
std::vector<Response> random_responses(const TetrahedralMesh& mesh, unsigned seed);

/// [response][band] what a run reads.
std::vector<std::vector<double>> responses_of_run(const Problem& problem, const DirectionSet& directions,
                                                  const std::vector<Response>& responses,
                                                  SolveOptions options);

/// [response] The largest difference between what a run reads and the sum of what its importance says,
/// relative to it, over the bands.
std::vector<double> duality_errors(const Problem& problem, const DirectionSet& directions,
                                   const std::vector<Response>& responses, const SolveOptions& options);

}  // namespace etendue
