// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "base/index.h"

namespace etendue {

struct SavedState;

/// A source in the cells and an inflow at the walls that depend on the direction and come on top of the
/// problem's own: a manufactured solution, or the last step of a march in time; and a state that
/// was solved on other directions.
class AngularInput {
 public:
  virtual ~AngularInput() = default;
  /// Returns whether the source of a cell differs between ordinates. Where it does not, add_source is asked
  /// for one ordinate only, and the cell takes no memory for each of them.
  virtual bool depends_on_direction(CellIndex) const { return true; }
  /// Adds the source at the four vertices of a cell along ordinate m to `values` [4][band]
  /// [power/(length^3 sr)]. Called by several threads at a time.
  virtual void add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const = 0;
  /// Adds the values at the four vertices of the L2 projection of a source that may vary more within a cell
  /// than linear functions follow, such as light that is attenuated within a thick cell. What counts of it
  /// are its integrals with the basis functions: lumping would move the source by up to the size of the cell,
  /// so cells with lumped mass take these integrals as they are. Arguments as above; called by several
  /// threads at a time.
  virtual void add_projected_source(OrdinateIndex, CellIndex, std::span<double>) const {}
  /// Adds the radiance that enters at the three vertices of a boundary face to `values` [3][band]
  /// [power/(length^2 sr)]. Called by several threads at a time.
  virtual void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const = 0;
  /// State that is prescribed beside the one that is solved for: every sweep adds its fluence, moments and
  /// irradiance to those that the next sweep scatters and reflects. Null: none.
  virtual const SavedState* prescribed_state() const { return nullptr; }
};

}  // namespace etendue
