// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "solver/adjoint/response.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_options.h"

namespace etendue {

/// Bytes of radiance that a gradient keeps at a time, of both solutions.
inline constexpr std::size_t gradient_bytes = std::size_t{256} << 20;

/// Derivatives of a response <r, u> by what a problem says, at the solution.
struct Gradient {
  /// [cell][band] by the coefficient of the cell [response length]; that by scattering at the same phase
  /// function. Divided by the volume of the cell they are functional derivatives, which do not depend on the
  /// mesh.
  std::vector<double> absorption, scattering;
  /// [cell][band] by the isotropic emission [response length^3 sr/power]
  std::vector<double> emission;
  /// [boundary face][band] by the radiance that the wall emits [response length^2 sr/power], not a
  /// number where it refracts, and by its diffuse reflectance [response]
  std::vector<double> radiance, diffuse;
};

/// The gradient of a response by one solution of the problem and one of its adjoint,
///
///     dJ/dsigma_a = -integral over the cell of sum w_m u_m u+_m,
///     dJ/dsigma_s = dJ/dsigma_a + <dS/dsigma_s u, u+>,   dJ/dq = <1, u+>,   dJ/drho = <E/pi_h, u+>,
///
/// with the masses of the discrete equations, so that it is that of the discrete response (Marchuk 1995,
/// chapter 2). Two sweeps of each solution more give the products of ordinates, some at a time: no angular
/// solution is stored. What a region absorbs changes by its own absorption too, which is counted.
/// `solution` is that of solve() and `importance` that of solve_adjoint(), as they were found with these
/// options on this one set. Throws InputError where light is followed along rays (see on_directions()) or a
/// medium scatters by a matrix.
Gradient gradient_of(const Problem& problem, const DirectionSet& directions, const Response& response,
                     const SolveOptions& options, const Solution& solution, const Solution& importance);

/// Throws InputError with the media that scatter by a matrix on this set.
void check_gradient(const Problem& problem, const DirectionSet& directions);

/// The same problem with all light left to the directions.
Problem on_directions(const Problem& problem);

}  // namespace etendue
