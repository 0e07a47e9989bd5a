// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/transport/order/sweep_slots.h"
#include "solver/transport/sweep/discretization.h"

namespace etendue {

/// Source and inflow of the angular input (AngularInput), added to the right-hand sides and inflow slots of a
/// sweep.
class DirectionalInput {
 public:
  /// `discretization` must outlive it.
  explicit DirectionalInput(const Discretization& discretization) : d_(discretization) {}

  /// Whether a sweep with this emission has such input.
  bool acts(Emission emission) const {
    return d_.options.angular_input != nullptr && emission == Emission::included;
  }
  /// Adds the source of the cells first … last - 1 in which it is isotropic to the sources of their records.
  template <class Real>
  void add_isotropic_source(std::int32_t first, std::int32_t last, Real* records) const;
  /// Adds the source along ordinate m to the rows of the angular cells, the scratch row first.
  template <class Real>
  void add_source(OrdinateIndex m, Real* rows) const;
  /// Adds the radiance that enters along ordinate m to the inflow slots, and its flux to `exitance` unless
  /// that is empty.
  template <class Real>
  void add_inflow(OrdinateIndex m, const SweepSlotsOf<Real>& slots, std::span<double> exitance) const;

 private:
  /// Adds the source of one cell to its right-hand side [node][stride]. `values` [4][band] is scratch.
  template <class Real>
  void add_cell(OrdinateIndex m, CellIndex cell, std::vector<double>& values, Real* right) const;

  const Discretization& d_;
};

}  // namespace etendue
