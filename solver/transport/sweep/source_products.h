// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/solution/angular_input.h"
#include "solver/transport/order/sweep_slots.h"
#include "solver/transport/sweep/discretization.h"

namespace etendue {

/// Products of the paired sources with the radiance of a sweep, which is the adjoint one with all directions
/// reversed,
///
///     <s, u+> = sum over m of w_m (integral of s_m u_-m over the cells + integral of |w_m.n| g_m u_-m over
///     the walls),
///
/// with the masses of cells and faces that the sweep itself gives a source s and an inflow g: what the light
/// of the source gives of the quantity whose importance u+ is, to rounding.
class SourceProducts {
 public:
  /// `discretization` must outlive it.
  explicit SourceProducts(const Discretization& discretization) : d_(discretization) {}

  /// Adds to `products` [source][stride] what the radiance along ordinate m gives in the cells where sources
  /// depend on the direction, and at the walls. `rows` are those of the angular cells, the scratch row first.
  template <class Real>
  void add(OrdinateIndex m, const Real* rows, const SweepSlotsOf<Real>& slots,
           std::span<double> products) const;
  /// Adds what the fluence [cell][node][stride] gives in the other cells.
  void add_isotropic(std::span<const double> fluence, std::span<double> products) const;

 private:
  /// Adds the product of one cell, whose radiance times its weight [node][stride] is `radiance`.
  template <class Real>
  void add_cell(const AngularInput& source, OrdinateIndex m, CellIndex cell, const Real* radiance,
                double weight, std::span<double> products) const;
  /// Adds the products of the inflow along ordinate m.
  template <class Real>
  void add_walls(const AngularInput& source, OrdinateIndex m, const SweepSlotsOf<Real>& slots,
                 std::span<double> products) const;

  const Discretization& d_;
};

}  // namespace etendue
