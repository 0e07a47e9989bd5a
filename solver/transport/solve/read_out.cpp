// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/read_out.h"

#include <fmt/format.h>

#include <utility>

#include "solver/transport/scattering/scattering_report.h"
#include "solver/transport/state/state_copy.h"
#include "solver/transport/sweep/source_products.h"

namespace etendue {
namespace {

/// Values at nodes, [item][node][stride], as [item][wanted][band]: constants are repeated at every vertex.
std::vector<double> vertex_values(std::span<const double> values, std::size_t nodes, std::size_t wanted,
                                  std::size_t stride, std::size_t bands) {
  const std::size_t items = values.size() / (nodes * stride);
  std::vector<double> result(items * wanted * bands);
  for (std::size_t item = 0; item < items; ++item)
    for (std::size_t i = 0; i < wanted; ++i)
      for (std::size_t b = 0; b < bands; ++b)
        result[(item * wanted + i) * bands + b] = values[(item * nodes + (nodes == 1 ? 0 : i)) * stride + b];
  return result;
}

/// [cell][3][node][stride] as [cell][4][3][band].
std::vector<double> net_flux_at_vertices(std::span<const double> values, std::size_t nodes,
                                         std::size_t stride, std::size_t bands) {
  const std::size_t cells = values.size() / (3 * nodes * stride);
  std::vector<double> result(cells * 12 * bands);
  for (std::size_t c = 0; c < cells; ++c)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t b = 0; b < bands; ++b)
          result[((c * 4 + i) * 3 + axis) * bands + b] =
              values[((c * 3 + axis) * nodes + (nodes == 1 ? 0 : i)) * stride + b];
  return result;
}

std::vector<OrdinateFixup> fixups_of(const TransportSweep& sweep) {
  std::vector<OrdinateFixup> fixups;
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  for (std::size_t at = 0; at < sweep.fixup_census().size(); ++at) {
    const auto band = static_cast<int>(at % stride);
    if (band >= sweep.cells().bands()) continue;
    const OrdinateIndex m(static_cast<std::int32_t>(at / stride));
    const FixupCensus& census = sweep.fixup_census()[at];
    const Vec3& w = sweep.directions().direction(m);
    fixups.push_back({m.value(),
                      band,
                      {w.x(), w.y(), w.z()},
                      sweep.directions().weight(m),
                      census.cells,
                      census.failed,
                      census.smallest,
                      census.moved});
  }
  return fixups;
}

/// Sets the power that is absorbed per volume where it does not depend on the direction, [cell][band].
void complete_absorbed(const TransportSweep& sweep, Solution& solution) {
  const auto bands = static_cast<std::size_t>(sweep.cells().bands());
  for (std::size_t i = 0; i < solution.absorbed.size(); ++i) {
    const CellIndex cell(static_cast<std::int64_t>(i / bands));
    const int band = static_cast<int>(i % bands);
    if (sweep.discretization().dense.absorbs_by_direction(cell, band)) continue;
    double mean = 0;
    for (std::size_t node = 0; node < 4; ++node)
      mean += solution.fluence[(cell.at() * 4 + node) * bands + i % bands] / 4;
    solution.absorbed[i] = sweep.problem().absorption(cell, band) * mean;
  }
}

}  // namespace

void read_out(const TransportSweep& sweep, const TransportState& state, SweepRecord& record,
              Solution& solution) {
  const auto bands = static_cast<std::size_t>(sweep.cells().bands());
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  const auto nodes = static_cast<std::size_t>(sweep.cells().nodes());
  const auto face_nodes = static_cast<std::size_t>(sweep.cells().face_nodes());
  solution.fluence = vertex_values(state.fluence(), nodes, 4, stride, bands);
  solution.net_flux = net_flux_at_vertices(record.net_flux.span(), nodes, stride, bands);
  solution.irradiance = vertex_values(state.irradiance(), face_nodes, 3, stride, bands);
  solution.exitance = vertex_values(record.exitance.span(), face_nodes, 3, stride, bands);
  for (OrdinateRadiance& kept : record.radiance) {
    solution.radiance.push_back({kept.ordinate, vertex_values(kept.values, nodes, 4, stride, bands)});
    kept.values = {};  // those of all ordinates are large
  }
  solution.meters = vertex_values(record.meters, 1, 1, stride, bands);
  SourceProducts(sweep.discretization()).add_isotropic(state.fluence(), record.source_products);
  solution.source_products = vertex_values(record.source_products, 1, 1, stride, bands);
  solution.state = saved(state, sweep.cells().bands());
  const std::span<const std::int32_t> angular_cells = sweep.discretization().moments.angular_cells();
  solution.angular_cells.assign(angular_cells.begin(), angular_cells.end());
  solution.absorbed = std::move(record.absorbed);
  complete_absorbed(sweep, solution);
  solution.negative = negative_census(solution.fluence, bands);
  solution.half_range = sweep.walls().emission_range();
  solution.fixups = fixups_of(sweep);
  solution.lagged_faces = static_cast<int>(sweep.discretization().orders->lagged_total());
  solution.kernels =
      report_kernels(sweep.problem(), sweep.directions(), sweep.discretization().scattering.plan,
                     sweep.discretization().scattering.groups);
}

std::vector<std::string> notes_of(const TransportSweep& sweep) {
  const SolveOptions& options = sweep.discretization().options;
  std::vector<std::string> notes;
  notes.push_back(fmt::format("kernel {}, {} threads", sweep.instruction_set(), sweep.threads()));
  if (options.order == SpaceOrder::linear && options.lumping == Lumping::automatic)
    notes.push_back(fmt::format(
        "mass lumped in {} of {} cells and bands (extinction times cell size above 2)",
        sweep.cells().lumped_count(), static_cast<long>(sweep.mesh().cell_count()) * sweep.cells().bands()));
  if (sweep.discretization().orders->kept_count() < sweep.discretization().orders->pair_count())
    notes.push_back(fmt::format(
        "{} of {} sweep orders kept, the others made again in every sweep (memory bound)",
        sweep.discretization().orders->kept_count(), sweep.discretization().orders->pair_count()));
  if (sweep.discretization().orders->lagged_total() > 0)
    notes.push_back(fmt::format("{} faces lagged to break cycles of the sweep order",
                                sweep.discretization().orders->lagged_total()));
  for (std::string& note : sweep.walls().glossy().notes()) notes.push_back(std::move(note));
  if (sweep.is_direct()) notes.push_back("nothing scatters or reflects: one sweep solves it");
  return notes;
}

}  // namespace etendue
