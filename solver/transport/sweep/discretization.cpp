// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/discretization.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/parallel/thread_count.h"
#include "solver/problem/band_selection.h"
#include "solver/solution/angular_input.h"
#include "solver/transport/order/batch_sections.h"

namespace etendue {
namespace {

/// Visits of cells in a batch from which on threads share the batches. With fewer, one thread is faster than
/// several that wait for each other.
constexpr std::int64_t smallest_shared_batch = 4096;

/// From this degree on products of moments cost more than groups of neighbors save in the visits.
constexpr int smallest_degree_of_images = 4;

Batches batches_for(int degree) {
  return degree < smallest_degree_of_images ? Batches::of_neighbours : Batches::of_images;
}

Basis basis_of(const SolveOptions& options) {
  return options.order == SpaceOrder::linear ? Basis::linear : Basis::constant;
}

ScatteringTreatments treat_scattering(const Problem& problem, const DirectionSet& directions) {
  ScatteringTreatments treatments{plan_scattering(problem, directions), {}};
  treatments.groups = dense_groups(problem, directions, treatments.plan);
  return treatments;
}

/// Cells whose radiance is needed direction by direction: those with a directional source, their own or one
/// that is paired with it, or a meter.
std::vector<CellIndex> observed_cells(const TetrahedralMesh& mesh, const SolveOptions& options) {
  std::vector<const AngularInput*> inputs = options.paired_sources;
  if (options.angular_input != nullptr) inputs.push_back(options.angular_input);
  std::vector<CellIndex> cells;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    if (std::ranges::any_of(inputs, [&](const auto* s) { return s->depends_on_direction(CellIndex(c)); }))
      cells.push_back(CellIndex(c));
  for (const IrradianceMeter& meter : options.meters)
    for (const CellPoint& point : meter.cells) cells.push_back(point.cell);
  return cells;
}

AddedExtinction added_extinction(const SolveOptions& options) {
  return options.added_extinction != nullptr ? *options.added_extinction : AddedExtinction{};
}

/// The same for a subset of the bands, in which both bands of a pair are, or neither.
AddedExtinction added_extinction(const Discretization& wide, std::span<const int> bands) {
  const auto wide_bands = static_cast<std::size_t>(wide.cells.bands());
  if (wide.added.real.empty()) return {};
  if (!wide.added.is_complex())
    return {select_bands(std::span<const double>(wide.added.real), wide_bands, bands), {}};
  std::vector<int> pairs;
  for (std::size_t i = 0; i < bands.size(); i += 2) pairs.push_back(bands[i] / 2);
  return {select_bands(std::span<const double>(wide.added.real), wide_bands / 2, pairs),
          select_bands(std::span<const double>(wide.added.imaginary), wide_bands / 2, pairs)};
}

/// Options of sweeps without sources, of which nothing but the next state is wanted.
SolveOptions without_record(SolveOptions options) {
  options.angular_input = nullptr;
  options.paired_sources.clear();
  options.keep_ordinates.clear();
  options.meters.clear();
  options.orders_share = {};
  options.sweep_share = {};
  return options;
}

/// The pairs whose ordinates this rank sweeps.
OwnPairs own_pairs(const OrdinateSchedule& schedule, RankGroup* ranks) {
  OwnPairs own{ranks, {}};
  if (ranks == nullptr) return own;
  own.are_own.assign(static_cast<std::size_t>(schedule.place_count() / 2), 0);
  const BatchSections sections(schedule.batch_count());
  const std::int32_t end = sections.first_batch_of(ranks->rank() + 1, ranks->count());
  for (std::int32_t batch = sections.first_batch_of(ranks->rank(), ranks->count()); batch < end; ++batch)
    for (std::int32_t place = batch * schedule.batch(); place < schedule.batch_end(batch); ++place)
      own.are_own[schedule.ordinate(place).at() / 2] = 1;
  return own;
}

std::shared_ptr<const SweepOrders> timed_orders(const TetrahedralMesh& mesh, const DirectionSet& directions,
                                                const CellCoefficients& cells,
                                                const OrdinateSchedule& schedule, const SolveOptions& options,
                                                double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t cell_bytes = (cells.layout().length + cells.cell_length()) * sizeof(double);
  const auto cell_count = static_cast<std::size_t>(mesh.cell_count());
  auto orders = std::make_shared<const SweepOrders>(
      mesh, directions, cells_per_tile(cell_count, cell_bytes, options.cache_bytes),
      skips_faces(cells.stride()) ? LevelOrder::alike : LevelOrder::neighbours, options.order_memory,
      thread_count(options.threads), options.stops, options.orders_share, own_pairs(schedule, options.ranks));
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return orders;
}

}  // namespace

Discretization::Discretization(const Problem& given, const DirectionSet& set,
                               std::span<const double> extinction_of_cells, const SolveOptions& wanted,
                               std::shared_ptr<const SweepOrders> known_orders, Scalar scalar)
    : Discretization(given, set, extinction_of_cells, wanted, added_extinction(wanted), scalar,
                     treat_scattering(given, set), std::move(known_orders),
                     std::make_shared<WaitingSections>()) {}

Discretization::Discretization(const Discretization& other, Scalar scalar)
    : Discretization(other.problem, other.directions, other.extinction, other.options, other.added, scalar,
                     other.scattering, other.orders, other.waiting) {}

Discretization::Discretization(const Discretization& wide, const Problem& given,
                               std::span<const double> extinction_of_cells, std::span<const int> bands,
                               Scalar scalar)
    : Discretization(given, wide.directions, extinction_of_cells, wide.options, added_extinction(wide, bands),
                     scalar,
                     {select_bands(std::span<const ScatteringTreatment>(wide.scattering.plan),
                                   static_cast<std::size_t>(wide.cells.bands()), bands),
                      of_bands(wide.scattering.groups, bands)},
                     wide.orders, wide.waiting) {}

Discretization::Discretization(const Discretization& fine, const DirectionSet& set, Scalar scalar)
    : Discretization(fine.problem, set, fine.extinction, without_record(fine.options), fine.added, scalar,
                     {scattering_on_fewer(fine.problem, set, fine.scattering.plan), {}}, nullptr,
                     fine.waiting) {}

Discretization::Discretization(const Problem& given, const DirectionSet& set,
                               std::span<const double> extinction_of_cells, const SolveOptions& wanted,
                               AddedExtinction added_part, Scalar scalar, ScatteringTreatments treatments,
                               std::shared_ptr<const SweepOrders> known_orders,
                               std::shared_ptr<WaitingSections> known_waiting)
    : problem(given),
      directions(set),
      extinction(extinction_of_cells),
      options(wanted),
      added(std::move(added_part)),
      scattering(std::move(treatments)),
      cells(problem.mesh(), effective_extinction(problem, extinction, scattering.plan, scattering.groups),
            added, problem.band_count(), basis_of(options), options.lumping, scalar),
      schedule(problem, directions, batches_for(highest_degree(scattering.plan))),
      moments(problem, directions, cells, scattering.plan, schedule, observed_cells(problem.mesh(), options)),
      dense(problem, directions, cells, extinction, scattering.plan, scattering.groups),
      orders(known_orders
                 ? std::move(known_orders)
                 : timed_orders(problem.mesh(), directions, cells, schedule, options, order_seconds)),
      waiting(std::move(known_waiting)),
      walls(problem, directions, schedule, orders->walls(), cells.stride(), cells.face_nodes()) {}

std::size_t Discretization::fluence_size() const {
  return static_cast<std::size_t>(problem.mesh().cell_count()) * cells.cell_length();
}

StateLayout Discretization::layout() const {
  return {fluence_size(),          moments.moments_size(), dense.radiance_size(),
          walls.irradiance_size(), walls.mirror_size(),    2 * orders->lagged_total() * cells.trace_length()};
}

bool Discretization::is_direct() const {
  return !walls.feeds_back() && orders->lagged_total() == 0 &&
         std::ranges::all_of(problem.scattering(), [](double s) { return s == 0; });
}

int Discretization::sweep_threads() const {
  if (std::int64_t{problem.mesh().cell_count()} * schedule.batch() < smallest_shared_batch) return 1;
  return std::min(thread_count(options.threads), schedule.batch_count());
}

}  // namespace etendue
