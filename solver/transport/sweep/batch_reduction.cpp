// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/batch_reduction.h"

#include <algorithm>

#include "base/parallel/processor_timer.h"

namespace etendue {
namespace {

/// Cells that one thread adds up at a time.
constexpr std::int32_t block_cells = 1024;
/// The same of rows of moments, which are longer.
constexpr std::int64_t reduced_rows = 64;

/// to += from; from = 0
template <class Real>
void move_sum(double* to, Real* from, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    to[i] += from[i];
    from[i] = 0;
  }
}

}  // namespace

template <class Real>
void BatchReduction<Real>::add(std::int32_t first_batch, Workspaces workspaces, const SweepPass& pass) const {
  const std::int32_t cells = d_.problem.mesh().cell_count();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int32_t first = 0; first < cells; first += block_cells) {
    const ProcessorTimer timer(seconds_);
    add_cells(first, std::min(cells, first + block_cells), workspaces, pass);
  }
  add_moments(first_batch, workspaces, pass);
  for (const auto& work : workspaces) {
    move_sum(pass.next.irradiance().data(), work->irradiance.data(), work->irradiance.size());
    if (pass.record == nullptr) continue;
    move_sum(pass.record->exitance.data(), work->exitance.data(), work->exitance.size());
    move_sum(pass.record->meters.data(), work->meters.data(), work->meters.size());
    move_sum(pass.record->source_products.data(), work->source_products.data(), work->source_products.size());
    move_sum(pass.record->absorbed.data(), work->absorbed.data(), work->absorbed.size());
  }
}

template <class Real>
void BatchReduction<Real>::add_cells(std::int32_t first, std::int32_t last, Workspaces workspaces,
                                     const SweepPass& pass) const {
  const std::size_t begin = static_cast<std::size_t>(first) * d_.cells.cell_length();
  const std::size_t size = static_cast<std::size_t>(last - first) * d_.cells.cell_length();
  for (const auto& work : workspaces) {
    move_sum(pass.next.fluence().data() + begin, work->fluence.data() + begin, size);
    if (pass.record != nullptr)
      move_sum(pass.record->net_flux.data() + 3 * begin, work->net_flux.data() + 3 * begin, 3 * size);
  }
}

template <class Real>
void BatchReduction<Real>::add_moments(std::int32_t first_batch, Workspaces workspaces,
                                       const SweepPass& pass) const {
  const auto rows = static_cast<std::int64_t>(d_.moments.row_count());
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int64_t first = 0; first < rows; first += reduced_rows) {
    const ProcessorTimer timer(seconds_);
    for (std::size_t t = 0; t < workspaces.size(); ++t)
      moments_.directions_to_moments(
          static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(rows, first + reduced_rows)),
          first_batch + static_cast<std::int32_t>(t), workspaces[t]->rows, pass.next);
  }
}

template class BatchReduction<double>;
template class BatchReduction<float>;

}  // namespace etendue
