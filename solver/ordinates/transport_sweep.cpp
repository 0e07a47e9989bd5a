// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/transport_sweep.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>

namespace etendue {
namespace {

/// Ordinates of one batch. It decides the order of sums, so it must not depend on the number of threads:
/// small enough to share a small set among a few threads, large enough that adding up batches and reading the
/// moments of angular cells, once for each batch, cost little.
constexpr std::int32_t largest_batch = 32;
std::int32_t batch_size(int ordinates) { return ordinates <= 32 ? 8 : ordinates <= 128 ? 16 : largest_batch; }

/// Cells that one thread adds up at a time.
constexpr std::int32_t merge_block = 1024;

double processor_clock() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// to += from; from = 0
void move_sum(double* to, double* from, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    to[i] += from[i];
    from[i] = 0;
  }
}

SweepOrders timed_orders(const TetrahedralMesh& mesh, const DirectionSet& directions,
                         const SolveOptions& options, int threads, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  SweepOrders orders(mesh, directions, options.order_memory, threads);
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return orders;
}

}  // namespace

/// What one thread needs while it sweeps a batch; sums are zero between batches.
struct TransportSweep::Workspace {
  AlignedArray traces;
  AlignedArray fluence;
  AlignedArray irradiance;
  AlignedArray angular;  ///< [ordinate of the batch][1 + row][node][stride]
  AlignedArray net_flux;
  AlignedArray exitance;
  AlignedArray whole;  ///< [1 + cell][node][stride] of an ordinate that is kept
  std::vector<double> meters;
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
      cells_(problem.mesh(), extinction, problem.band_count(),
             options.order == SpaceOrder::linear ? Basis::linear : Basis::constant, options.lumping),
      scattering_(problem, directions, cells_, observed_cells()),
      walls_(problem, directions, cells_.stride(), cells_.face_nodes()),
      orders_(timed_orders(problem.mesh(), directions, options, threads_, order_seconds_)),
      kernels_(choose_kernels(cells_.basis(), cells_.stride())),
      source_(static_cast<std::size_t>(problem.mesh().cell_count()) * scattering_.row_length()),
      moment_source_(scattering_.moments_size()) {
  threads_ = std::min(threads_, static_cast<int>(batch_count()));
  const std::size_t trace_length = cells_.trace_length();
  const std::size_t rows = scattering_.row_count() > 0 ? scattering_.row_count() + 1 : 0;
  for (int t = 0; t < threads_; ++t) {
    auto work = std::make_unique<Workspace>();
    work->traces = AlignedArray(static_cast<std::size_t>(orders_.largest_slot_count()) * trace_length);
    work->fluence = AlignedArray(source_.size());
    work->irradiance = AlignedArray(walls_.irradiance_size());
    work->angular = AlignedArray(static_cast<std::size_t>(batch_size(directions.count())) * rows *
                                 scattering_.row_length());
    workspaces_.push_back(std::move(work));
  }
}

TransportSweep::~TransportSweep() = default;

std::vector<CellIndex> TransportSweep::observed_cells() const {
  std::vector<CellIndex> cells;
  for (std::int32_t c = 0; angular_input_ != nullptr && c < problem_.mesh().cell_count(); ++c)
    cells.push_back(CellIndex(c));
  for (const IrradianceMeter& meter : meters_)
    for (const CellPoint& point : meter.cells) cells.push_back(point.cell);
  return cells;
}

std::int32_t TransportSweep::batch_count() const {
  const std::int32_t size = batch_size(directions_.count());
  return (directions_.count() + size - 1) / size;
}

StateLayout TransportSweep::layout() const {
  const auto trace_length = cells_.trace_length();
  return {source_.size(), scattering_.moments_size(), walls_.irradiance_size(), walls_.mirror_size(),
          2 * orders_.lagged_total() * trace_length};
}

bool TransportSweep::is_direct() const {
  const auto scattering = problem_.scattering();
  return !walls_.reflects() && orders_.lagged_total() == 0 &&
         std::all_of(scattering.begin(), scattering.end(), [](double s) { return s == 0; });
}

void TransportSweep::form_source(const TransportState& last) {
  const std::int32_t cells = problem_.mesh().cell_count();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int32_t first = 0; first < cells; first += merge_block)
    scattering_.form_source(last, emission_, first, std::min(cells, first + merge_block), source_.data(),
                            moment_source_.data());
}

void TransportSweep::apply(const TransportState& last, TransportState& next, SweepRecord* record) {
  emission_ = Emission::included;
  sweep_all(last, next, record);
}

void TransportSweep::apply_linear(const TransportState& last, TransportState& next) {
  emission_ = Emission::left_out;
  sweep_all(last, next, nullptr);
}

void TransportSweep::sweep_all(const TransportState& last, TransportState& next, SweepRecord* record) {
  const double start = processor_clock();
  form_source(last);
  std::fill(next.fluence().begin(), next.fluence().end(), 0.0);
  std::fill(next.moments().begin(), next.moments().end(), 0.0);
  std::fill(next.irradiance().begin(), next.irradiance().end(), 0.0);
  if (record != nullptr) {
    record->net_flux = AlignedArray(3 * source_.size());
    record->exitance = AlignedArray(walls_.irradiance_size());
    record->meters.assign(meters_.size() * static_cast<std::size_t>(cells_.stride()), 0);
    record->radiance.clear();
    for (const int ordinate : keep_ordinates_)
      record->radiance.push_back({ordinate, std::vector<double>(source_.size())});
    if (!keep_ordinates_.empty()) {
      all_cells_index_.resize(static_cast<std::size_t>(problem_.mesh().cell_count()));
      std::iota(all_cells_index_.begin(), all_cells_index_.end(), 1);
    }
    for (auto& work : workspaces_) {
      work->net_flux = AlignedArray(record->net_flux.size());
      work->exitance = AlignedArray(record->exitance.size());
      work->meters.assign(record->meters.size(), 0);
      if (!keep_ordinates_.empty()) work->whole = AlignedArray(source_.size() + scattering_.row_length());
    }
  }
  for (std::int32_t first = 0; first < batch_count(); first += threads_) {
    const int batches = std::min(threads_, static_cast<int>(batch_count() - first));
#pragma omp parallel for schedule(static, 1) num_threads(batches)
    for (int t = 0; t < batches; ++t)
      sweep_batch(first + t, last, next, record, *workspaces_[static_cast<std::size_t>(t)]);
    merge(first, batches, next, record);
  }
  if (record != nullptr)
    for (auto& work : workspaces_) work->net_flux = work->exitance = work->whole = AlignedArray();
  processor_seconds_ += processor_clock() - start;
  ++sweep_count_;
}

void TransportSweep::sweep_batch(std::int32_t batch, const TransportState& last, TransportState& next,
                                 SweepRecord* record, Workspace& work) {
  const std::int32_t size = batch_size(directions_.count());
  const std::int32_t first = batch * size;
  const std::int32_t end = std::min(directions_.count(), first + size);
  const std::size_t angular_length = (scattering_.row_count() + 1) * scattering_.row_length();
  const auto angular_of = [&](std::int32_t m) {
    return work.angular.size() == 0
               ? nullptr
               : work.angular.data() + static_cast<std::size_t>(m - first) * angular_length;
  };
  if (scattering_.row_count() > 0) {
    std::vector<double*> rows;
    for (std::int32_t m = first; m < end; ++m) rows.push_back(angular_of(m) + scattering_.row_length());
    MomentTask task;
    task.row_length = scattering_.row_length();
    task.moments = scattering_.moment_count();
    task.directions = end - first;
    task.matrix = scattering_.evaluation(OrdinateIndex(first));
    task.moment_rows = moment_source_.data();
    task.direction_rows = rows.data();
    task.last_row = scattering_.row_count();
    kernels_.moments_to_directions(task);
    const bool shines = angular_input_ != nullptr && emission_ == Emission::included;
    for (std::int32_t m = first; shines && m < end; ++m) add_angular_source(OrdinateIndex(m), angular_of(m));
  }
  for (std::int32_t m = first; m < end; m += 2) {
    const SweepOrder& order = orders_.of_pair(m / 2, work.scratch_order);
    sweep_ordinate(OrdinateIndex(m), order, last, next, record, angular_of(m), work);
    sweep_ordinate(OrdinateIndex(m + 1), order, last, next, record, angular_of(m + 1), work);
  }
}

void TransportSweep::sweep_ordinate(OrdinateIndex m, const SweepOrder& order, const TransportState& last,
                                    TransportState& next, SweepRecord* record, double* angular,
                                    Workspace& work) {
  walls_.send(m, last, emission_, work.traces.data(), work.exitance.span());
  if (angular_input_ != nullptr && emission_ == Emission::included)
    add_angular_inflow(m, work.traces.data(), work.exitance.span());
  exchange_lagged(m, order, last, work);
  run_kernel(m, order, record, angular, work);
  walls_.receive(m, work.traces.data(), work.irradiance.span(), next.mirrors());
  keep_lagged(m, order, next, work);
  if (record != nullptr && !meters_.empty()) read_meters(m, angular, work.meters);
}

void TransportSweep::run_kernel(OrdinateIndex m, const SweepOrder& order, SweepRecord* record,
                                double* angular, Workspace& work) {
  SweepTask task;
  task.cell_count = problem_.mesh().cell_count();
  task.cells = order.cells.data();
  task.slots = order.slots.data();
  task.backwards = m.value() % 2 == 1;
  for (int axis = 0; axis < 3; ++axis) task.direction[axis] = directions_.direction(m)[axis];
  task.weight = directions_.weight(m);
  task.stride = cells_.stride();
  task.normals = cells_.normals();
  task.mass = cells_.mass();
  task.source = source_.data();
  task.angular_index = scattering_.index();
  task.angular = angular;
  task.traces = work.traces.data();
  task.fluence = work.fluence.data();
  task.net_flux = record != nullptr ? work.net_flux.data() : nullptr;
  const auto kept = std::find(keep_ordinates_.begin(), keep_ordinates_.end(), m.value());
  if (record == nullptr || kept == keep_ordinates_.end()) {
    kernels_.sweep(task);
    return;
  }
  // To keep this ordinate's radiance every cell gets a row.
  const std::size_t length = scattering_.row_length();
  double* whole = work.whole.data() + length;
  std::copy(source_.data(), source_.data() + source_.size(), whole);
  for (const std::int32_t cell : scattering_.angular_cells()) {
    const double* row = angular + static_cast<std::size_t>(scattering_.row(CellIndex(cell))) * length;
    std::copy(row, row + length, whole + static_cast<std::size_t>(cell) * length);
  }
  task.angular_index = all_cells_index_.data();
  task.angular = work.whole.data();
  kernels_.sweep(task);
  auto& values = record->radiance[static_cast<std::size_t>(kept - keep_ordinates_.begin())].values;
  std::copy(whole, whole + source_.size(), values.begin());
  for (const std::int32_t cell : scattering_.angular_cells()) {
    const double* row = whole + static_cast<std::size_t>(cell) * length;
    std::copy(row, row + length,
              angular + static_cast<std::size_t>(scattering_.row(CellIndex(cell))) * length);
  }
}

void TransportSweep::exchange_lagged(OrdinateIndex m, const SweepOrder& order, const TransportState& last,
                                     Workspace& work) const {
  const auto length = cells_.trace_length();
  const std::size_t parity = m.at() % 2;
  for (std::size_t i = 0; i < order.lagged.size(); ++i) {
    const LaggedFace& face = order.lagged[i];
    const double* value =
        last.lagged().data() + (2 * (orders_.lagged_start(m.value() / 2) + i) + parity) * length;
    const std::int32_t read = parity == 0 ? face.downwind_slot : face.upwind_slot;
    std::copy(value, value + length, work.traces.data() + static_cast<std::size_t>(read) * length);
  }
}

void TransportSweep::keep_lagged(OrdinateIndex m, const SweepOrder& order, TransportState& next,
                                 const Workspace& work) const {
  const auto length = cells_.trace_length();
  const std::size_t parity = m.at() % 2;
  for (std::size_t i = 0; i < order.lagged.size(); ++i) {
    const LaggedFace& face = order.lagged[i];
    const std::int32_t written = parity == 0 ? face.upwind_slot : face.downwind_slot;
    const double* value = work.traces.data() + static_cast<std::size_t>(written) * length;
    std::copy(value, value + length,
              next.lagged().data() + (2 * (orders_.lagged_start(m.value() / 2) + i) + parity) * length);
  }
}

void TransportSweep::add_angular_source(OrdinateIndex m, double* angular) const {
  const auto bands = static_cast<std::size_t>(cells_.bands());
  const auto stride = static_cast<std::size_t>(cells_.stride());
  const auto nodes = static_cast<std::size_t>(cells_.nodes());
  std::vector<double> values(4 * bands);
  for (const std::int32_t c : scattering_.angular_cells()) {
    const CellIndex cell(c);
    std::fill(values.begin(), values.end(), 0.0);
    angular_input_->add_source(m, cell, values);
    double* right = angular + static_cast<std::size_t>(scattering_.row(cell)) * scattering_.row_length();
    for (std::size_t b = 0; b < bands; ++b) {
      const CellCoefficients::SourceFactors mass = cells_.source_factors(cell, static_cast<int>(b));
      const double total = values[b] + values[bands + b] + values[2 * bands + b] + values[3 * bands + b];
      for (std::size_t i = 0; i < nodes; ++i) {
        // A constant element has the mean of the four values.
        const double own = nodes == 1 ? total / 4 : values[i * bands + b];
        right[i * stride + b] += mass.sum * total + mass.own * own;
      }
    }
  }
}

void TransportSweep::add_angular_inflow(OrdinateIndex m, double* traces, std::span<double> exitance) const {
  const auto bands = static_cast<std::size_t>(cells_.bands());
  const auto stride = static_cast<std::size_t>(cells_.stride());
  const auto nodes = static_cast<std::size_t>(cells_.face_nodes());
  std::vector<double> values(3 * bands);
  for (std::int32_t f = 0; f < problem_.mesh().boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const double seen = seen_area(problem_.mesh().area_normal(face), directions_.direction(m));
    if (seen >= 0) continue;
    std::fill(values.begin(), values.end(), 0.0);
    angular_input_->add_inflow(m, face, values);
    const double factor = -seen / problem_.mesh().area(face) * directions_.weight(m);
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t b = 0; b < bands; ++b) {
        const double value =
            nodes == 1 ? (values[b] + values[bands + b] + values[2 * bands + b]) / 3 : values[i * bands + b];
        traces[((1 + face.at()) * nodes + i) * stride + b] += value;
        if (!exitance.empty()) exitance[(face.at() * nodes + i) * stride + b] += factor * value;
      }
  }
}

void TransportSweep::read_meters(OrdinateIndex m, const double* angular, std::span<double> meters) const {
  const auto stride = static_cast<std::size_t>(cells_.stride());
  for (std::size_t i = 0; i < meters_.size(); ++i) {
    const double cosine = directions_.direction(m).dot(meters_[i].normal);
    if (cosine >= 0) continue;
    double volume = 0;
    for (const CellPoint& point : meters_[i].cells) volume += problem_.mesh().volume(point.cell);
    for (const CellPoint& point : meters_[i].cells) {
      const double factor = -cosine * directions_.weight(m) * problem_.mesh().volume(point.cell) / volume;
      const double* u =
          angular + static_cast<std::size_t>(scattering_.row(point.cell)) * scattering_.row_length();
      for (std::size_t node = 0; node < static_cast<std::size_t>(cells_.nodes()); ++node) {
        const double share = cells_.nodes() == 1 ? 1 : point.barycentric[node];
        for (std::size_t b = 0; b < stride; ++b)
          meters[i * stride + b] += factor * share * u[node * stride + b];
      }
    }
  }
}

void TransportSweep::merge(std::int32_t first_batch, int batches, TransportState& next, SweepRecord* record) {
  const std::int32_t cells = problem_.mesh().cell_count();
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int32_t first = 0; first < cells; first += merge_block)
    merge_cells(first, std::min(cells, first + merge_block), batches, next, record);
  const auto rows = static_cast<std::int64_t>(scattering_.row_count());
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (std::int64_t first = 0; first < rows; first += merge_block / 16)
    for (int t = 0; t < batches; ++t)
      merge_moments(static_cast<std::size_t>(first),
                    static_cast<std::size_t>(std::min(rows, first + merge_block / 16)), first_batch + t,
                    *workspaces_[static_cast<std::size_t>(t)], next);
  for (int t = 0; t < batches; ++t) {
    Workspace& work = *workspaces_[static_cast<std::size_t>(t)];
    move_sum(next.irradiance().data(), work.irradiance.data(), work.irradiance.size());
    if (record == nullptr) continue;
    move_sum(record->exitance.data(), work.exitance.data(), work.exitance.size());
    move_sum(record->meters.data(), work.meters.data(), work.meters.size());
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
  const std::int32_t size = batch_size(directions_.count());
  const std::int32_t ordinate = batch * size;
  const std::size_t length = scattering_.row_length();
  MomentTask task;
  task.row_length = length;
  task.moments = scattering_.moment_count();
  task.directions = std::min(directions_.count() - ordinate, size);
  task.matrix = scattering_.integration(OrdinateIndex(ordinate));
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
