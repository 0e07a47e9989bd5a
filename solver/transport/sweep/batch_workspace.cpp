// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/batch_workspace.h"

namespace etendue {

template <class Real>
BatchWorkspace<Real>::BatchWorkspace(const Discretization& d, std::size_t rows_length)
    : members(d.orders->step_count() > 1 ? static_cast<std::size_t>(largest_group) : 1),
      radiance(members.size() * d.orders->largest_slot_count() * d.cells.cell_length()),
      rows(rows_length),
      records(d.dense.empty()
                  ? 0
                  : (static_cast<std::size_t>(d.problem.mesh().cell_count()) + 1) * d.cells.layout().length),
      fluence(d.fluence_size() + d.cells.cell_length()),
      irradiance(d.walls.irradiance_size()) {
  const std::size_t slots_length = d.orders->largest_slot_count() * d.cells.cell_length();
  for (std::size_t i = 0; i < members.size(); ++i)
    members[i].slots = {radiance.data() + i * slots_length, d.cells.cell_length(),
                        static_cast<std::size_t>(d.cells.stride())};
}

template <class Real>
void BatchWorkspace<Real>::begin_record(const Discretization& d, const SweepRecord& record) {
  // The idle cell has a flux too.
  net_flux = AlignedArrayOf<Real>(record.net_flux.size() + 3 * d.cells.cell_length());
  exitance = AlignedArray(record.exitance.size());
  meters.assign(record.meters.size(), 0);
  source_products.assign(record.source_products.size(), 0);
  absorbed.assign(record.absorbed.size(), 0);
  if (!record.radiance.empty()) all_rows = AlignedArrayOf<Real>(d.fluence_size() + d.cells.cell_length());
}

template <class Real>
void BatchWorkspace<Real>::end_record() {
  net_flux = all_rows = AlignedArrayOf<Real>();
  exitance = AlignedArray();
}

template struct BatchWorkspace<double>;
template struct BatchWorkspace<float>;

}  // namespace etendue
