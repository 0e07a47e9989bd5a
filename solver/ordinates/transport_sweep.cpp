// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/transport_sweep.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "solver/ordinates/processor_timer.h"

namespace etendue {
namespace {

/// The largest of ordinates_per_batch.
constexpr std::int32_t largest_batch = 32;

/// Visits of cells in a batch from which on threads share the batches.
constexpr std::int64_t smallest_shared_batch = 4096;

/// Cells that one thread adds up at a time.
constexpr std::int32_t merge_block = 1024;

/// to += from; from = 0
void move_sum(double* to, double* from, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    to[i] += from[i];
    from[i] = 0;
  }
}

Basis basis_of(const SolveOptions& options) {
  return options.order == SpaceOrder::linear ? Basis::linear : Basis::constant;
}

SweepOrders timed_orders(const TetrahedralMesh& mesh, const DirectionSet& directions,
                         const SolveOptions& options, int threads, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  SweepOrders orders(mesh, directions, options.order_memory, threads);
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return orders;
}

}  // namespace

std::int32_t ordinates_per_batch(int ordinates) {
  return ordinates <= 32 ? 8 : ordinates <= 128 ? 16 : largest_batch;
}

/// What one thread needs while it sweeps a batch; sums are zero between batches.
struct TransportSweep::Workspace {
  AlignedArray radiance;  ///< of `slots`
  SweepSlots slots;
  AlignedArray fluence;  ///< [cell + 1][node][stride]
  AlignedArray irradiance;
  AlignedArray angular;  ///< [ordinate of the batch][1 + row][node][stride]
  AlignedArray net_flux;
  AlignedArray exitance;
  AlignedArray whole;  ///< [1 + cell][node][stride] of an ordinate that is kept
  std::vector<double> meters;
  std::vector<double> absorbed;
  AlignedArray records;  ///< as those of the sweep, with the mass of one ordinate where it depends on it
  SweepOrder scratch_order;
};

TransportSweep::TransportSweep(const Problem& problem, const DirectionSet& directions,
                               std::span<const double> extinction, const SolveOptions& options)
    : problem_(problem),
      directions_(directions),
      meters_(options.meters),
      keep_ordinates_(options.keep_ordinates),
      angular_input_(options.angular_input),
      threads_(options.threads > 0 ? options.threads : omp_get_num_procs()),
      plan_(plan_scattering(problem, directions)),
      dense_groups_(dense_groups(problem, directions, plan_)),
      cells_(problem.mesh(), effective_extinction(problem, extinction, plan_, dense_groups_),
             problem.band_count(), basis_of(options), options.lumping),
      schedule_(problem, directions, ordinates_per_batch(directions.count())),
      scattering_(problem, directions, cells_, plan_, schedule_, observed_cells()),
      dense_(problem, directions, cells_, extinction, plan_, dense_groups_),
      orders_(timed_orders(problem.mesh(), directions, options, threads_, order_seconds_)),
      walls_(problem, directions, schedule_, orders_.walls(), cells_.stride(), cells_.face_nodes()),
      kernels_(choose_kernels(cells_.basis(), cells_.stride())),
      records_(cells_.make_records()),
      inflow_(walls_.irradiance_size()),
      passing_(walls_.passing_size()),
      moment_source_(scattering_.moments_size()) {
  threads_ = std::min(threads_, static_cast<int>(batch_count()));
  // Where a batch is done in less time than threads need to meet, one is faster.
  if (std::int64_t{problem.mesh().cell_count()} * ordinates_per_batch(directions.count()) <
      smallest_shared_batch)
    threads_ = 1;
  const std::size_t rows = scattering_.row_count() > 0 ? scattering_.row_count() + 1 : 0;
  for (int t = 0; t < threads_; ++t) {
    auto work = std::make_unique<Workspace>();
    work->radiance = AlignedArray(orders_.largest_slot_count() * cells_.cell_length());
    work->slots = {work->radiance.data(), cells_.cell_length(), static_cast<std::size_t>(cells_.stride())};
    work->fluence = AlignedArray(fluence_size() + cells_.cell_length());
    work->irradiance = AlignedArray(walls_.irradiance_size());
    work->angular = AlignedArray(static_cast<std::size_t>(ordinates_per_batch(directions.count())) * rows *
                                 scattering_.row_length());
    if (!dense_.empty()) work->records = AlignedArray(records_.size());
    workspaces_.push_back(std::move(work));
  }
}

TransportSweep::~TransportSweep() = default;

std::vector<CellIndex> TransportSweep::observed_cells() const {
  std::vector<CellIndex> cells;
  for (std::int32_t c = 0; angular_input_ != nullptr && c < problem_.mesh().cell_count(); ++c)
    if (angular_input_->depends_on_direction(CellIndex(c))) cells.push_back(CellIndex(c));
  for (const IrradianceMeter& meter : meters_)
    for (const CellPoint& point : meter.cells) cells.push_back(point.cell);
  return cells;
}

std::int32_t TransportSweep::batch_count() const {
  const std::int32_t size = ordinates_per_batch(directions_.count());
  return (directions_.count() + size - 1) / size;
}

std::size_t TransportSweep::fluence_size() const {
  return static_cast<std::size_t>(problem_.mesh().cell_count()) * cells_.cell_length();
}

StateLayout TransportSweep::layout() const {
  const auto trace_length = cells_.trace_length();
  return {fluence_size(),           scattering_.moments_size(), dense_.radiance_size(),
          walls_.irradiance_size(), walls_.mirror_size(),       2 * orders_.lagged_total() * trace_length};
}

bool TransportSweep::is_direct() const {
  const auto scattering = problem_.scattering();
  return !walls_.feeds_back() && orders_.lagged_total() == 0 &&
         std::all_of(scattering.begin(), scattering.end(), [](double s) { return s == 0; });
}

void TransportSweep::form_source(const TransportState& last) {
  walls_.form_inflow(last, emission_, inflow_.span());
  const std::int32_t cells = problem_.mesh().cell_count();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int32_t first = 0; first < cells; first += merge_block) {
    const ProcessorTimer timer(processor_seconds_);
    scattering_.form_source(last, emission_, first, std::min(cells, first + merge_block), records_.data(),
                            moment_source_.data());
    if (angular_input_ != nullptr && emission_ == Emission::included)
      add_isotropic_source(first, std::min(cells, first + merge_block));
  }
  dense_.form_source(last, kernels_, threads_, processor_seconds_);
  for (auto& work : workspaces_) std::copy_n(records_.data(), work->records.size(), work->records.data());
}

void TransportSweep::apply(const TransportState& last, TransportState& next, SweepRecord* record) {
  emission_ = Emission::included;
  sweep_all(last, next, record);
}

void TransportSweep::keep_positive(Fixup fixup) {
  fixup_ = fixup;
  census_.resize(static_cast<std::size_t>(directions_.count()) * static_cast<std::size_t>(cells_.stride()));
}

void TransportSweep::apply_linear(const TransportState& last, TransportState& next) {
  emission_ = Emission::left_out;
  sweep_all(last, next, nullptr);
}

void TransportSweep::apply_to_unit_source(TransportState& next) {
  emission_ = Emission::left_out;
  scattering_.form_unit_source(records_.data(), moment_source_.data());
  sweep_source(TransportState(layout()), next, nullptr);
}

void TransportSweep::sweep_all(const TransportState& last, TransportState& next, SweepRecord* record) {
  form_source(last);
  std::fill(census_.begin(), census_.end(), FixupCensus());
  sweep_source(last, next, record);
}

void TransportSweep::sweep_source(const TransportState& last, TransportState& next, SweepRecord* record) {
  std::fill(next.fluence().begin(), next.fluence().end(), 0.0);
  std::fill(next.moments().begin(), next.moments().end(), 0.0);
  std::fill(next.irradiance().begin(), next.irradiance().end(), 0.0);
  if (record != nullptr) {
    record->net_flux = AlignedArray(3 * fluence_size());
    record->exitance = AlignedArray(walls_.irradiance_size());
    record->meters.assign(meters_.size() * static_cast<std::size_t>(cells_.stride()), 0);
    const std::size_t values =
        static_cast<std::size_t>(problem_.mesh().cell_count()) * static_cast<std::size_t>(cells_.bands());
    record->absorbed.assign(dense_.absorbs_by_direction() ? values : 0, 0);
    record->radiance.clear();
    for (const int ordinate : keep_ordinates_)
      record->radiance.push_back({ordinate, std::vector<double>(fluence_size())});
    if (!keep_ordinates_.empty()) {
      all_cells_index_.resize(static_cast<std::size_t>(problem_.mesh().cell_count()) + 1);
      std::iota(all_cells_index_.begin(), all_cells_index_.end() - 1, 1);
      all_cells_index_.back() = 0;
    }
    for (auto& work : workspaces_) {
      // The idle cell has a flux too.
      work->net_flux = AlignedArray(record->net_flux.size() + 3 * cells_.cell_length());
      work->exitance = AlignedArray(record->exitance.size());
      work->meters.assign(record->meters.size(), 0);
      work->absorbed.assign(record->absorbed.size(), 0);
      if (!keep_ordinates_.empty()) work->whole = AlignedArray(fluence_size() + scattering_.row_length());
    }
  }
  for (std::int32_t first = 0; first < batch_count(); first += threads_) {
    const int batches = std::min(threads_, static_cast<int>(batch_count() - first));
#pragma omp parallel for schedule(static, 1) num_threads(batches)
    for (int t = 0; t < batches; ++t) {
      const ProcessorTimer timer(processor_seconds_);
      sweep_batch(first + t, last, next, record, *workspaces_[static_cast<std::size_t>(t)]);
    }
    merge(first, batches, next, record);
  }
  if (record != nullptr)
    for (auto& work : workspaces_) work->net_flux = work->exitance = work->whole = AlignedArray();
  ++sweep_count_;
}

void TransportSweep::sweep_batch(std::int32_t batch, const TransportState& last, TransportState& next,
                                 SweepRecord* record, Workspace& work) {
  const std::int32_t size = ordinates_per_batch(directions_.count());
  const std::int32_t first = batch * size;
  const std::int32_t end = std::min(directions_.count(), first + size);
  const std::size_t angular_length = (scattering_.row_count() + 1) * scattering_.row_length();
  const auto angular_of = [&](std::int32_t place) {
    return work.angular.size() == 0
               ? nullptr
               : work.angular.data() + static_cast<std::size_t>(place - first) * angular_length;
  };
  if (scattering_.row_count() > 0) {
    std::vector<double*> rows;
    for (std::int32_t place = first; place < end; ++place)
      rows.push_back(angular_of(place) + scattering_.row_length());
    MomentTask task;
    task.row_length = scattering_.row_length();
    task.moments = scattering_.moment_count();
    task.directions = end - first;
    task.matrix = scattering_.evaluation(first);
    task.moment_rows = moment_source_.data();
    task.direction_rows = rows.data();
    task.last_row = scattering_.row_count();
    kernels_.moments_to_directions(task);
    const bool shines = angular_input_ != nullptr && emission_ == Emission::included;
    for (std::int32_t place = first; !dense_.empty() && place < end; ++place)
      dense_.add_source(schedule_.ordinate(place), scattering_.index(), angular_of(place));
    for (std::int32_t place = first; shines && place < end; ++place)
      add_angular_source(schedule_.ordinate(place), angular_of(place));
  }
  std::int32_t pair = -1;
  const SweepOrder* order = nullptr;
  for (std::int32_t place = first; place < end; ++place) {
    if (const std::int32_t wanted = schedule_.ordinate(place).value() / 2; wanted != pair)
      order = &orders_.of_pair(pair = wanted, work.scratch_order);
    sweep_ordinate(place, *order, last, next, record, angular_of(place), work);
  }
}

void TransportSweep::sweep_ordinate(std::int32_t place, const SweepOrder& order, const TransportState& last,
                                    TransportState& next, SweepRecord* record, double* angular,
                                    Workspace& work) {
  const OrdinateIndex m = schedule_.ordinate(place);
  // What comes in by direction is added to the slots, which then have to be filled again.
  const bool shines = angular_input_ != nullptr && emission_ == Emission::included;
  if (shines || place % schedule_.batch() == 0) walls_.fill(inflow_.span(), work.slots);
  walls_.reflect(m, last, passing_.span(), inflow_.span(), work.slots);
  if (record != nullptr) walls_.add_exitance(m, work.slots, work.exitance.span());
  if (shines) add_angular_inflow(m, work.slots, work.exitance.span());
  set_lagged(m, order, last, work.slots);
  run_kernel(m, order, record, angular, work);
  if (!dense_.empty()) dense_.keep_radiance(m, scattering_.index(), angular, next);
  if (record != nullptr && dense_.absorbs_by_direction())
    dense_.add_absorbed(m, scattering_.index(), angular, work.absorbed);
  walls_.receive(m, work.slots, record != nullptr ? TakeUp::all : TakeUp::reflecting, work.irradiance.span(),
                 next.mirrors(), passing_.span());
  keep_lagged(m, order, next, work.slots);
  if (record != nullptr && !meters_.empty()) read_meters(m, angular, work.meters);
}

void TransportSweep::call_kernel(const SweepTask& task) const {
  if (task.census != nullptr) {
    kernels_.sweep_positive(task);
  } else {
    kernels_.sweep(task);
  }
}

void TransportSweep::run_kernel(OrdinateIndex m, const SweepOrder& order, SweepRecord* record,
                                double* angular, Workspace& work) {
  SweepTask task;
  task.visits = order.visits.data();
  task.levels = order.levels.data();
  task.level_count = static_cast<std::int32_t>(order.levels.size()) - 1;
  task.idle_cell = static_cast<std::uint32_t>(problem_.mesh().cell_count());
  task.backwards = m.value() % 2 == 1;
  for (int axis = 0; axis < 3; ++axis) task.direction[axis] = directions_.direction(m)[axis];
  task.weight = directions_.weight(m);
  task.stride = cells_.stride();
  task.records = records_.data();
  if (!dense_.empty()) {
    dense_.set_mass(m, work.records.data());
    task.records = work.records.data();
  }
  task.slots = work.radiance.data();
  task.fluence = work.fluence.data();
  task.angular_index = scattering_.index();
  task.angular = angular;
  task.net_flux = record != nullptr ? work.net_flux.data() : nullptr;
  if (!census_.empty() && emission_ == Emission::included) {
    task.volumes = problem_.mesh().volumes().data();
    task.fixup = fixup_;
    task.census = &census_[m.at() * static_cast<std::size_t>(cells_.stride())];
  }
  const auto kept = std::find(keep_ordinates_.begin(), keep_ordinates_.end(), m.value());
  if (record == nullptr || kept == keep_ordinates_.end()) {
    call_kernel(task);
    return;
  }
  sweep_and_keep(task, record->radiance[static_cast<std::size_t>(kept - keep_ordinates_.begin())],
                 work.whole.span());
}

void TransportSweep::merge(std::int32_t first_batch, int batches, TransportState& next, SweepRecord* record) {
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

void TransportSweep::merge_cells(std::int32_t first, std::int32_t last, int batches, TransportState& next,
                                 SweepRecord* record) {
  const std::size_t begin = static_cast<std::size_t>(first) * scattering_.row_length();
  const std::size_t size = static_cast<std::size_t>(last - first) * scattering_.row_length();
  for (int t = 0; t < batches; ++t) {
    Workspace& work = *workspaces_[static_cast<std::size_t>(t)];
    move_sum(next.fluence().data() + begin, work.fluence.data() + begin, size);
    if (record != nullptr)
      move_sum(record->net_flux.data() + 3 * begin, work.net_flux.data() + 3 * begin, 3 * size);
  }
}

void TransportSweep::merge_moments(std::size_t first, std::size_t last, std::int32_t batch, Workspace& work,
                                   TransportState& next) const {
  const std::int32_t size = ordinates_per_batch(directions_.count());
  const std::int32_t first_place = batch * size;
  const std::size_t length = scattering_.row_length();
  MomentTask task;
  task.row_length = length;
  task.moments = scattering_.moment_count();
  task.directions = std::min(directions_.count() - first_place, size);
  task.matrix = scattering_.integration(first_place);
  task.moment_rows = next.moments().data();
  double* rows[largest_batch];
  for (std::size_t j = 0; j < static_cast<std::size_t>(task.directions); ++j)
    rows[j] = work.angular.data() + j * (scattering_.row_count() + 1) * length + length;
  task.direction_rows = rows;
  task.first_row = first;
  task.last_row = last;
  kernels_.directions_to_moments(task);
}

}  // namespace etendue
