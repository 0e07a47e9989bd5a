// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "solver/transport/order/sweep_orders.h"
#include "solver/transport/order/sweep_slots.h"
#include "solver/transport/sweep/discretization.h"
#include "solver/transport/sweep/sweep_record.h"

namespace etendue {

/// Arrays of one thread while it sweeps a batch of ordinates. Sums are zero between batches.
template <class Real>
struct BatchWorkspace {
  /// Slots and order of one ordinate of a group.
  struct Member {
    SweepSlotsOf<Real> slots;
    bool is_filled = false;  ///< with the radiance of the walls that is alike for all ordinates of a sweep
    OwnedOrder remade_order;
  };

  /// `rows_length` is the number of numbers of the rows of a batch, MomentOperators::batch_length().
  BatchWorkspace(const Discretization& discretization, std::size_t rows_length);

  /// Makes room for the record of a sweep.
  void begin_record(const Discretization& discretization, const SweepRecord& record);
  /// Gives the larger part of that room back.
  void end_record();

  std::vector<Member> members;                   ///< [ordinate of a group]
  AlignedArrayOf<Real> radiance;                 ///< of all slots, [member][slot][node][stride]
  std::unique_ptr<SweepOrderMaker> order_maker;  ///< null while no order was made again
  AlignedArrayOf<Real>
      rows;  ///< right-hand side, then radiance, [ordinate of the batch][1 + row][node][stride]
  AlignedArrayOf<Real>
      records;  ///< those of the sweep with the mass of one ordinate; empty where no mass depends on it
  AlignedArrayOf<Real> fluence;         ///< [cell + 1][node][stride]
  AlignedArray irradiance;              ///< [boundary face][face node][stride]
  AlignedArrayOf<Real> net_flux;        ///< [cell + 1][3][node][stride]
  AlignedArray exitance;                ///< [boundary face][face node][stride]
  AlignedArrayOf<Real> all_rows;        ///< [1 + cell][node][stride] of an ordinate whose radiance is kept
  std::vector<double> meters;           ///< [meter][stride]
  std::vector<double> source_products;  ///< [paired source][stride]
  std::vector<double> absorbed;         ///< [cell][band]
};

extern template struct BatchWorkspace<double>;
extern template struct BatchWorkspace<float>;

}  // namespace etendue
