// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/acceleration/coarse_directions.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace etendue {

CoarseDirections::CoarseDirections(const TransportSweep& fine, DirectionSet directions)
    : directions_(std::move(directions)),
      sweep_(fine.discretization(), directions_),
      last_(sweep_.layout()),
      next_(sweep_.layout()) {
  find_shared(fine);
}

void CoarseDirections::find_shared(const TransportSweep& fine) {
  const StateLayout to = fine.layout(), from = sweep_.layout();
  shared_.push_back({0, 0, to.fluence});
  const ScatteringMoments& many = fine.discretization().moments;
  const ScatteringMoments& few = sweep_.discretization().moments;
  const std::size_t of_many = static_cast<std::size_t>(many.moment_count()) * many.row_length();
  const std::size_t of_few = static_cast<std::size_t>(few.moment_count()) * few.row_length();
  for (std::size_t row = 0; row < few.row_count(); ++row) {
    const std::int32_t in_fine = many.row(CellIndex(few.angular_cells()[row]));
    if (in_fine > 0)
      shared_.push_back({to.fluence + static_cast<std::size_t>(in_fine - 1) * of_many,
                         from.fluence + row * of_few, std::min(of_few, of_many)});
  }
  shared_.push_back(
      {to.fluence + to.moments + to.radiance, from.fluence + from.moments + from.radiance, to.irradiance});
}

void CoarseDirections::apply_linear(const TransportState& last, TransportState& next,
                                    std::span<const char> active) {
  for (const Shared& run : shared_)
    std::copy_n(last.values().data() + run.fine, run.count, last_.values().data() + run.coarse);
  sweep_.apply_linear(last_, next_, active);
  ++sweeps_;
  std::ranges::fill(next.values(), 0.0);
  for (const Shared& run : shared_)
    std::copy_n(next_.values().data() + run.coarse, run.count, next.values().data() + run.fine);
}

std::string CoarseDirections::name() const {
  return fmt::format("{} {}", directions_.name(), directions_.order());
}

}  // namespace etendue
