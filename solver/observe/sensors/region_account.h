// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/quadrature/cone_cubature.h"
#include "solver/observe/sensors/region_surface.h"
#include "solver/solution/direction_set_solution.h"
#include "solver/solution/solve_options.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// Balance of the light in a region, of the directions of travel in a cone: integrals of the transport
/// equation over both, per band,
///
///     flowing_out - flowing_in + absorbed + scattered_out = emitted + scattered_in.
///
/// Light that scatters from one direction of the cone into another is scattered out and in.
struct RegionAccount {
  explicit RegionAccount(std::size_t bands);

  double solid_angle = 0;          ///< of the ordinates that count [sr]; in the plane [rad]
  std::vector<double> path;        ///< [band] integral of u over the region and them [power length]
  std::vector<double> flowing_in;  ///< [band] through its surface [power], and so the others
  std::vector<double> flowing_out;
  std::vector<double> emitted;
  std::vector<double> absorbed;
  std::vector<double> scattered_in;
  std::vector<double> scattered_out;

  double coming_in(std::size_t band) const;  ///< flowing_in + emitted + scattered_in [power]
  double missing(std::size_t band) const;    ///< coming_in less what becomes of it [power]
  /// What the account misses, relative to all that comes in.
  double residual(std::size_t band) const;
  void add(const RegionAccount& other, double factor);
};

/// What an account is of.
struct AccountScope {
  int region = -1;                   ///< whose cells count; -1: none, and what flows is all there is
  std::vector<SurfaceFace> surface;  ///< through which it flows; of a region all of it, that it may close
  std::optional<Cone> cone;          ///< directions of travel that count; without it all
};

/// A region and all of its surface.
AccountScope region_scope(const TetrahedralMesh& mesh, int region, const std::optional<Cone>& cone);

/// Of the light that directions carried, from the radiance of all ordinates, which the solution must have
/// kept (SolveOptions::keep_ordinates), and its state. Through the faces
/// of the mesh flows what its upwind cell has there, as in the sweep, so that the account closes as far as
/// the iteration has converged. Light of lights that scatters for the first time, or is reflected diffusely,
/// comes with the input: it is scattered in, or flows in. Light that has collided once on a set of its own is
/// added; the solid angle is that of the rest.
RegionAccount region_account(const LightSetup& lights, const SolveOptions& options,
                             const DirectionSetSolution& swept, const AccountScope& scope);

}  // namespace etendue
