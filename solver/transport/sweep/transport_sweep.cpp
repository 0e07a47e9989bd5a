// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/transport_sweep.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/parallel/processor_timer.h"
#include "solver/solution/saved_state.h"
#include "solver/transport/sweep/active_band_sweep.h"
#include "solver/transport/sweep/sweep_workspace.h"
#include "solver/transport/sweep/transport_sweep_active_bands.h"
#include "solver/transport/sweep/transport_sweep_by_direction.h"
#include "solver/transport/sweep/transport_sweep_group.h"

namespace etendue {
namespace {

/// Visits of cells in a batch from which on threads share the batches.
constexpr std::int64_t smallest_shared_batch = 4096;

/// From this degree on products of moments cost more than groups of neighbours save in the visits.
constexpr int smallest_degree_of_images = 4;

Batches batches_for(int degree) {
  return degree < smallest_degree_of_images ? Batches::of_neighbours : Batches::of_images;
}

/// Cells that one thread adds up at a time.
constexpr std::int32_t merge_block = 1024;

/// to += from; from = 0
template <class Real>
void move_sum(double* to, Real* from, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    to[i] += from[i];
    from[i] = 0;
  }
}

Basis basis_of(const SolveOptions& options) {
  return options.order == SpaceOrder::linear ? Basis::linear : Basis::constant;
}

/// Adds fluence, moments and irradiance of a state that was saved.
void add_saved(const SavedState& from, int bands, TransportState& state) {
  const auto count = static_cast<std::size_t>(bands);
  const auto stride = static_cast<std::size_t>(lane_stride(bands));
  const auto add = [&](const std::vector<double>& values, std::span<double> to) {
    if (values.size() / count != to.size() / stride)
      throw std::logic_error("light that was found elsewhere has other moments");
    for (std::size_t row = 0; row * count < values.size(); ++row)
      for (std::size_t b = 0; b < count; ++b) to[row * stride + b] += values[row * count + b];
  };
  add(from.fluence, state.fluence());
  add(from.moments, state.moments());
  add(from.irradiance, state.irradiance());
}

std::shared_ptr<const SweepOrders> timed_orders(const TetrahedralMesh& mesh, const DirectionSet& directions,
                                                const CellCoefficients& cells, const SolveOptions& options,
                                                int threads, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t cell_bytes = (cells.layout().length + cells.cell_length()) * sizeof(double);
  const auto cell_count = static_cast<std::size_t>(mesh.cell_count());
  auto orders = std::make_shared<const SweepOrders>(
      mesh, directions, cells_per_tile(cell_count, cell_bytes, options.cache_bytes),
      skips_faces(cells.stride()) ? LevelOrder::alike : LevelOrder::neighbours, options.order_memory, threads,
      options.stops);
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return orders;
}

}  // namespace

template <class Real>
typename TransportSweepOf<Real>::Scattering TransportSweepOf<Real>::scattering_of(
    const Problem& problem, const DirectionSet& directions) {
  Scattering scattering{plan_scattering(problem, directions), {}};
  scattering.groups = dense_groups(problem, directions, scattering.plan);
  return scattering;
}

template <class Real>
TransportSweepOf<Real>::TransportSweepOf(const Problem& problem, const DirectionSet& directions,
                                         std::span<const double> extinction, const SolveOptions& options)
    : TransportSweepOf(problem, directions, extinction, options, scattering_of(problem, directions),
                       nullptr) {}

template <class Real>
TransportSweepOf<Real>::TransportSweepOf(const TransportSweepOf& wide, const Problem& problem,
                                         std::span<const double> extinction, std::span<const int> bands)
    : TransportSweepOf(problem, wide.directions_, extinction, wide.options_,
                       {select_bands(std::span<const ScatteringTreatment>(wide.plan_),
                                     static_cast<std::size_t>(wide.cells_.bands()), bands),
                        of_bands(wide.dense_groups_, bands)},
                       wide.orders_) {}

template <class Real>
template <class Other>
TransportSweepOf<Real>::TransportSweepOf(const TransportSweepOf<Other>& other)
    : TransportSweepOf(other.problem_, other.directions_, other.extinction_, other.options_,
                       {other.plan_, other.dense_groups_}, other.orders_) {}

template <class Real>
TransportSweepOf<Real>::TransportSweepOf(const Problem& problem, const DirectionSet& directions,
                                         std::span<const double> extinction, const SolveOptions& options,
                                         Scattering scattering, std::shared_ptr<const SweepOrders> orders)
    : problem_(problem),
      directions_(directions),
      extinction_(extinction),
      options_(options),
      threads_(options.threads > 0 ? options.threads : omp_get_num_procs()),
      plan_(std::move(scattering.plan)),
      dense_groups_(std::move(scattering.groups)),
      cells_(problem.mesh(), effective_extinction(problem, extinction, plan_, dense_groups_),
             problem.band_count(), basis_of(options), options.lumping, scalar_of<Real>),
      schedule_(problem, directions, batches_for(highest_degree(plan_))),
      scattering_(problem, directions, cells_, plan_, schedule_, observed_cells()),
      dense_(problem, directions, cells_, extinction, plan_, dense_groups_),
      orders_(orders ? std::move(orders)
                     : timed_orders(problem.mesh(), directions, cells_, options, threads_, order_seconds_)),
      walls_(problem, directions, schedule_, orders_->walls(), cells_.stride(), cells_.face_nodes()),
      kernels_(choose_kernels<Real>(cells_.basis(), cells_.stride())),
      records_(cells_.template make_records<Real>()),
      inflow_(walls_.irradiance_size()),
      passing_(walls_.passing_size()),
      moment_source_(scattering_.moments_size()),
      evaluation_(scattering_.orbits().evaluation().begin(), scattering_.orbits().evaluation().end()),
      integration_(scattering_.orbits().integration().begin(), scattering_.orbits().integration().end()) {
  if constexpr (!adds_in_place) moment_sums_ = AlignedArrayOf<Real>(scattering_.moments_size());
  make_workspaces();
}

template <class Real>
TransportSweepOf<Real>::~TransportSweepOf() = default;

template <class Real>
void TransportSweepOf<Real>::make_workspaces() {
  threads_ = std::min(threads_, schedule_.batch_count());
  // Where a batch is done in less time than threads need to meet, one is faster.
  if (std::int64_t{problem_.mesh().cell_count()} * schedule_.batch() < smallest_shared_batch) threads_ = 1;
  for (int t = 0; t < threads_; ++t) {
    auto work = std::make_unique<Workspace>();
    const std::size_t members = is_tiled() ? static_cast<std::size_t>(largest_group) : 1;
    const std::size_t slots_length = orders_->largest_slot_count() * cells_.cell_length();
    work->radiance = AlignedArrayOf<Real>(members * slots_length);
    work->members.resize(members);
    for (std::size_t i = 0; i < members; ++i)
      work->members[i].slots = {work->radiance.data() + i * slots_length, cells_.cell_length(),
                                static_cast<std::size_t>(cells_.stride())};
    work->fluence = AlignedArrayOf<Real>(fluence_size() + cells_.cell_length());
    work->irradiance = AlignedArray(walls_.irradiance_size());
    work->angular = AlignedArrayOf<Real>(static_cast<std::size_t>(schedule_.batch()) * angular_length());
    if (!dense_.empty()) work->records = AlignedArrayOf<Real>(records_.size());
    workspaces_.push_back(std::move(work));
  }
}

template <class Real>
std::vector<CellIndex> TransportSweepOf<Real>::observed_cells() const {
  std::vector<CellIndex> cells;
  for (std::int32_t c = 0; options_.angular_input != nullptr && c < problem_.mesh().cell_count(); ++c)
    if (options_.angular_input->depends_on_direction(CellIndex(c))) cells.push_back(CellIndex(c));
  for (const IrradianceMeter& meter : options_.meters)
    for (const CellPoint& point : meter.cells) cells.push_back(point.cell);
  return cells;
}

template <class Real>
std::size_t TransportSweepOf<Real>::fluence_size() const {
  return static_cast<std::size_t>(problem_.mesh().cell_count()) * cells_.cell_length();
}

template <class Real>
StateLayout TransportSweepOf<Real>::layout() const {
  const auto trace_length = cells_.trace_length();
  return {fluence_size(),           scattering_.moments_size(), dense_.radiance_size(),
          walls_.irradiance_size(), walls_.mirror_size(),       2 * orders_->lagged_total() * trace_length};
}

template <class Real>
bool TransportSweepOf<Real>::is_direct() const {
  const auto scattering = problem_.scattering();
  return !walls_.feeds_back() && orders_->lagged_total() == 0 &&
         std::all_of(scattering.begin(), scattering.end(), [](double s) { return s == 0; });
}

template <class Real>
void TransportSweepOf<Real>::form_source(const TransportState& last) {
  walls_.form_inflow(last, emission_, threads_, inflow_.span());
  const std::int32_t cells = problem_.mesh().cell_count();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int32_t first = 0; first < cells; first += merge_block) {
    const ProcessorTimer timer(processor_seconds_);
    scattering_.form_source(last, emission_, first, std::min(cells, first + merge_block), records_.data(),
                            moment_source_.data());
    if (shines_by_direction()) add_isotropic_source(first, std::min(cells, first + merge_block));
  }
  dense_.form_source(last, kernels_.matrix_product, threads_, processor_seconds_);
  share_records();
}

template <class Real>
void TransportSweepOf<Real>::form_unit_source() {
  inflow_.fill_zero();
  scattering_.form_unit_source(records_.data(), moment_source_.data());
  dense_.clear_source();
  share_records();
}

template <class Real>
void TransportSweepOf<Real>::share_records() {
  for (auto& work : workspaces_) std::copy_n(records_.data(), work->records.size(), work->records.data());
}

template <class Real>
void TransportSweepOf<Real>::apply(const TransportState& last, TransportState& next, SweepRecord* record) {
  emission_ = Emission::included;
  sweep_all(last, next, record);
  if (options_.angular_input != nullptr && options_.angular_input->prescribed_state() != nullptr)
    add_saved(*options_.angular_input->prescribed_state(), cells_.bands(), next);
}

template <class Real>
void TransportSweepOf<Real>::keep_positive(Fixup fixup) {
  fixup_ = fixup;
  census_.resize(static_cast<std::size_t>(directions_.count()) * static_cast<std::size_t>(cells_.stride()));
}

template <class Real>
void TransportSweepOf<Real>::apply_linear(const TransportState& last, TransportState& next) {
  emission_ = Emission::left_out;
  sweep_all(last, next, nullptr);
}

template <class Real>
void TransportSweepOf<Real>::apply_to_unit_source(TransportState& next) {
  emission_ = Emission::left_out;
  form_unit_source();
  sweep_source(TransportState(layout()), next, nullptr);
}

template <class Real>
void TransportSweepOf<Real>::sweep_all(const TransportState& last, TransportState& next,
                                       SweepRecord* record) {
  form_source(last);
  std::fill(census_.begin(), census_.end(), FixupCensus());
  sweep_source(last, next, record);
}

template <class Real>
void TransportSweepOf<Real>::sweep_source(const TransportState& last, TransportState& next,
                                          SweepRecord* record) {
  std::fill(next.fluence().begin(), next.fluence().end(), 0.0);
  std::fill(next.moments().begin(), next.moments().end(), 0.0);
  std::fill(next.irradiance().begin(), next.irradiance().end(), 0.0);
  if (record != nullptr) {
    record->net_flux = AlignedArray(3 * fluence_size());
    record->exitance = AlignedArray(walls_.irradiance_size());
    record->meters.assign(options_.meters.size() * static_cast<std::size_t>(cells_.stride()), 0);
    const std::size_t values =
        static_cast<std::size_t>(problem_.mesh().cell_count()) * static_cast<std::size_t>(cells_.bands());
    record->absorbed.assign(dense_.absorbs_by_direction() ? values : 0, 0);
    record->radiance.clear();
    for (const int ordinate : options_.keep_ordinates)
      record->radiance.push_back({ordinate, std::vector<double>(fluence_size())});
    if (!options_.keep_ordinates.empty()) {
      all_cells_index_.resize(static_cast<std::size_t>(problem_.mesh().cell_count()) + 1);
      std::iota(all_cells_index_.begin(), all_cells_index_.end() - 1, 1);
      all_cells_index_.back() = 0;
    }
    for (auto& work : workspaces_) {
      // The idle cell has a flux too.
      work->net_flux = AlignedArrayOf<Real>(record->net_flux.size() + 3 * cells_.cell_length());
      work->exitance = AlignedArray(record->exitance.size());
      work->meters.assign(record->meters.size(), 0);
      work->absorbed.assign(record->absorbed.size(), 0);
      if (!options_.keep_ordinates.empty())
        work->whole = AlignedArrayOf<Real>(fluence_size() + scattering_.row_length());
    }
  }
  for (auto& work : workspaces_)
    for (auto& member : work->members) member.is_filled = false;
  for (std::int32_t first = 0; first < schedule_.batch_count(); first += threads_) {
    const int batches = std::min(threads_, schedule_.batch_count() - first);
#pragma omp parallel for schedule(static, 1) num_threads(batches)
    for (int t = 0; t < batches; ++t) {
      const ProcessorTimer timer(processor_seconds_);
      sweep_batch(first + t, last, next, record, *workspaces_[static_cast<std::size_t>(t)]);
    }
    if (stopped_) throw SweepStopped{};
    merge(first, batches, next, record);
  }
  if constexpr (!adds_in_place) {
    std::copy(moment_sums_.span().begin(), moment_sums_.span().end(), next.moments().begin());
    moment_sums_.fill_zero();
  }
  if (record != nullptr)
    for (auto& work : workspaces_) {
      work->net_flux = work->whole = AlignedArrayOf<Real>();
      work->exitance = AlignedArray();
    }
  band_sweep_count_ += cells_.bands();
}

template <class Real>
bool TransportSweepOf<Real>::is_stopped() {
  if (!stopped_ && options_.stops && options_.stops()) stopped_ = true;
  return stopped_;
}

template <class Real>
void TransportSweepOf<Real>::merge(std::int32_t first_batch, int batches, TransportState& next,
                                   SweepRecord* record) {
  const std::int32_t cells = problem_.mesh().cell_count();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int32_t first = 0; first < cells; first += merge_block) {
    const ProcessorTimer timer(processor_seconds_);
    merge_cells(first, std::min(cells, first + merge_block), batches, next, record);
  }
  const auto rows = static_cast<std::int64_t>(scattering_.row_count());
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int64_t first = 0; first < rows; first += merge_block / 16) {
    const ProcessorTimer timer(processor_seconds_);
    for (int t = 0; t < batches; ++t)
      merge_moments(static_cast<std::size_t>(first),
                    static_cast<std::size_t>(std::min(rows, first + merge_block / 16)), first_batch + t,
                    *workspaces_[static_cast<std::size_t>(t)], next);
  }
  for (int t = 0; t < batches; ++t) {
    Workspace& work = *workspaces_[static_cast<std::size_t>(t)];
    move_sum(next.irradiance().data(), work.irradiance.data(), work.irradiance.size());
    if (record == nullptr) continue;
    move_sum(record->exitance.data(), work.exitance.data(), work.exitance.size());
    move_sum(record->meters.data(), work.meters.data(), work.meters.size());
    move_sum(record->absorbed.data(), work.absorbed.data(), work.absorbed.size());
  }
}

template <class Real>
void TransportSweepOf<Real>::merge_cells(std::int32_t first, std::int32_t last, int batches,
                                         TransportState& next, SweepRecord* record) {
  const std::size_t begin = static_cast<std::size_t>(first) * scattering_.row_length();
  const std::size_t size = static_cast<std::size_t>(last - first) * scattering_.row_length();
  for (int t = 0; t < batches; ++t) {
    Workspace& work = *workspaces_[static_cast<std::size_t>(t)];
    move_sum(next.fluence().data() + begin, work.fluence.data() + begin, size);
    if (record != nullptr)
      move_sum(record->net_flux.data() + 3 * begin, work.net_flux.data() + 3 * begin, 3 * size);
  }
}

template <class Real>
void TransportSweepOf<Real>::merge_moments(std::size_t first, std::size_t last, std::int32_t batch,
                                           Workspace& work, TransportState& next) {
  const std::vector<Real*> rows = angular_rows(batch, work);
  MomentTaskOf<Real> task = moment_task(rows);
  task.matrix = integration_.data() + factors_begin(batch);
  if constexpr (adds_in_place) {
    task.moment_rows = next.moments().data();
  } else {
    task.moment_rows = moment_sums_.data();
  }
  task.first_row = first;
  task.last_row = last;
  kernels_.directions_to_moments(task);
}

template class TransportSweepOf<double>;
template class TransportSweepOf<float>;
template TransportSweepOf<float>::TransportSweepOf(const TransportSweepOf<double>&);

}  // namespace etendue
