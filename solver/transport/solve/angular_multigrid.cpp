// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/angular_multigrid.h"

#include <utility>

#include "solver/transport/solve/returned_light.h"

namespace etendue {
namespace {

/// Of the product set of 128 directions. With 32 for 384, or 16 for 128 in the plane, the sweeps that are
/// saved cost no more than the corrections.
constexpr int coarse_order = 8;
constexpr int fewest_finer = 6 * coarsest_directions;

}  // namespace

std::optional<DirectionSet> coarser_directions(const Problem& problem, const DirectionSet& directions,
                                               const SolveOptions& options) {
  if (options.angular_multigrid == AngularMultigrid::none || options.method == Method::source_iteration ||
      directions.space() == AngularSpace::plane || directions.count() < fewest_finer ||
      most_returns(problem) > many_returns)
    return std::nullopt;
  return directions_product(coarse_order);
}

std::unique_ptr<CoarseDirections> make_coarse_directions(const TransportSweep& sweep,
                                                         const SolveOptions& options) {
  const StateLayout layout = sweep.layout();
  if (sweep.is_direct() || options.max_sweeps <= 2 || layout.radiance > 0 || layout.mirrors > 0)
    return nullptr;
  std::optional<DirectionSet> directions = coarser_directions(sweep.problem(), sweep.directions(), options);
  if (!directions) return nullptr;
  return std::make_unique<CoarseDirections>(sweep, std::move(*directions));
}

}  // namespace etendue
