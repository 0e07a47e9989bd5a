// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/problem/following_sources.h"

namespace etendue {

/// Light in the cells and on the walls [power/length^2].
struct LightAtVertices {
  std::span<const double> fluence;  ///< [cell][4][band]
  std::span<const double>
      irradiance;  ///< [boundary face][3][band]; of walls whose emission follows, at least
  /// [boundary face] Exitance of a wall over its radiance, pi but for the directions [sr]; of light that is
  /// swept.
  std::span<const double> half_range = {};
};

/// Emission of media and walls that follows from the light itself, as where a temperature follows from the
/// heat that is absorbed. The transport equation is solved for an emission that is given; this one improves
/// it.
class FollowingEmission {
 public:
  virtual ~FollowingEmission() = default;
  /// Beside what the problem says.
  virtual const FollowingSources& sources() const = 0;
  /// Takes light that is not swept into account. It must outlive the solution.
  virtual void set_unswept(const LightAtVertices& light) = 0;
  /// Improves the emission by the swept light that the last one gave. Returns the estimated relative error of
  /// the emission before.
  virtual double improve(const LightAtVertices& light) = 0;
  /// What start_from() takes: all that another run needs to continue from here.
  virtual std::vector<double> state() const = 0;
  /// Throws InputError where it is the state of another problem.
  virtual void start_from(std::span<const double> state) = 0;
  /// Line on its state, for the user.
  virtual std::string note() const = 0;
};

}  // namespace etendue
