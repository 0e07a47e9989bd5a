// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "solver/problem/cell_emission.h"

namespace etendue {

/// Emission of media that follows from the light itself, as where a temperature follows from the heat that is
/// absorbed. The transport equation is solved for an emission that is given; this one improves it.
class FollowingEmission {
 public:
  virtual ~FollowingEmission() = default;
  /// Of the media, beside what the problem says.
  virtual const CellEmission& emission() const = 0;
  /// Takes light that is not swept into account: its fluence [cell][4][band] [power/length^2], which must
  /// outlive the solution.
  virtual void set_unswept(std::span<const double> fluence) = 0;
  /// Improves the emission by the fluence [cell][4][band] of swept light that the last one gave. Returns the
  /// estimated relative error of the emission before.
  virtual double improve(std::span<const double> fluence) = 0;
  /// Line on its state, for the user.
  virtual std::string note() const = 0;
};

}  // namespace etendue
