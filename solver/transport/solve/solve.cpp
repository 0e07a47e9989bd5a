// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>

#include "solver/problem/mirror.h"
#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "solver/transport/iteration/gmres.h"
#include "solver/transport/iteration/positive_iteration.h"
#include "solver/transport/iteration/source_iteration.h"
#include "solver/transport/order/sweep_stopped.h"
#include "solver/transport/scattering/scattering_report.h"
#include "solver/transport/source/directional_emission.h"
#include "solver/transport/source/ordinate_lights.h"
#include "solver/transport/state/state_copy.h"
#include "solver/transport/sweep/finite_check.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {
namespace {

/// Values at nodes, [item][node][stride], as [item][wanted][band]: constants are repeated at every vertex.
std::vector<double> unpadded(std::span<const double> values, std::size_t nodes, std::size_t wanted,
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

std::vector<double> extinction_of(const Problem& problem) {
  std::vector<double> extinction(problem.absorption().begin(), problem.absorption().end());
  for (std::size_t i = 0; i < extinction.size(); ++i) extinction[i] += problem.scattering()[i];
  return extinction;
}

std::vector<std::string> notes_of(const TransportSweep& sweep, const SolveOptions& options) {
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

std::unique_ptr<Iteration> make_iteration(Method method) {
  if (method == Method::source_iteration) return std::make_unique<SourceIteration>();
  return std::make_unique<Gmres>();
}

/// Whether a state to start from is one of values that were kept positive, so that the linear problem has
/// nothing to add.
bool starts_positive(const SolveOptions& options) {
  return options.positivity != Positivity::none && options.order == SpaceOrder::linear &&
         options.initial != nullptr &&
         std::ranges::all_of(options.initial->fluence, [](double value) { return value >= 0; });
}

/// Goes on from the solution of the linear problem, which took `used` sweeps with the one that measures, with
/// values that are kept positive, as many sweeps as are left.
void keep_positive(TransportSweep& sweep, TransportState& state, const SolveOptions& options,
                   DiffusionAcceleration* acceleration, const SolveObserver& observer, int used,
                   Solution& solution) {
  sweep.keep_positive(options.positivity == Positivity::rescale ? Fixup::rescale : Fixup::quadratic);
  if (sweep.is_direct() || solution.interrupted) return;
  if (options.max_sweeps <= used) {
    for (BandConvergence& band : solution.convergence) band.converged = false;
    solution.notes.push_back(
        "not converged: no sweeps are left after the linear solution to keep values positive");
    return;
  }
  const auto shifted = [&](const SweepProgress& progress) {
    SweepProgress all = progress;
    all.sweep += used - 1;
    all.max_sweeps = options.max_sweeps;
    return observer(all);
  };
  IterationResult result =
      PositiveIteration().run(sweep, state, {options.tolerance, options.max_sweeps - used, acceleration},
                              observer ? SolveObserver(shifted) : SolveObserver());
  for (std::size_t b = 0; b < result.bands.size(); ++b) {
    BandConvergence& band = result.bands[b];
    band.sweeps += used;
    band.converged = band.converged && solution.convergence[b].converged;
    solution.convergence[b] = band;
  }
  solution.notes.push_back(fmt::format("{} sweeps to keep values positive", result.sweeps));
  for (HistoryEntry entry : result.history) {
    entry.sweep += used - 1;
    solution.history.push_back(entry);
  }
  solution.interrupted = result.interrupted;
}

/// Of an iteration that had nothing to do.
IterationResult untouched(int bands) {
  IterationResult result;
  result.bands.assign(static_cast<std::size_t>(bands), {0, 0, true});
  return result;
}

std::vector<OrdinateFixup> fixups_of(const TransportSweep& sweep, const DirectionSet& directions) {
  std::vector<OrdinateFixup> fixups;
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  for (std::size_t at = 0; at < sweep.fixup_census().size(); ++at) {
    const auto band = static_cast<int>(at % stride);
    if (band >= sweep.cells().bands()) continue;
    const OrdinateIndex m(static_cast<std::int32_t>(at / stride));
    const FixupCensus& census = sweep.fixup_census()[at];
    const Vec3& w = directions.direction(m);
    fixups.push_back({m.value(),
                      band,
                      {w.x(), w.y(), w.z()},
                      directions.weight(m),
                      census.cells,
                      census.failed,
                      census.smallest,
                      census.moved});
  }
  return fixups;
}

/// Where less comes back, the iteration is quick by itself: with half of it scattered, Kobayashi's first
/// problem takes 11 sweeps and with acceleration 10, which cost more than one.
constexpr double little_return = 0.5;

/// Scatterings on a mean chord below which diffusion saves less than it costs, unless walls are brighter than
/// `bright_wall`: the smoke room, with 0.2 of them, takes 13 sweeps and with acceleration 12.
constexpr double few_scatterings = 1;
constexpr double bright_wall = 0.8;

/// The largest part of light that a wall sends back, or to its other side, otherwise than as a mirror.
double brightest_wall(const Problem& problem) {
  double brightest = 0;
  for (const Wall& wall : problem.walls())
    for (std::size_t b = 0; b < wall.diffuse.size(); ++b)
      brightest = std::max(brightest, wall.mean_reflectance(b) - wall.specular[b] + wall.transmitted(b));
  return brightest;
}

/// The largest part of what it takes out of a beam that a cell scatters.
double largest_albedo(const Problem& problem) {
  double largest = 0;
  for (std::size_t i = 0; i < problem.scattering().size(); ++i)
    if (problem.scattering()[i] > 0)
      largest =
          std::max(largest, problem.scattering()[i] / (problem.scattering()[i] + problem.absorption()[i]));
  return largest;
}

/// Scatterings on a mean chord 4 V/S of the domain, in the band where they are most. Mirrors do not end a
/// chord.
double scatterings_on_a_chord(const Problem& problem) {
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  double most = 0;
  for (std::size_t band = 0; band < bands; ++band) {
    double scattered = 0, surface = 0;
    for (std::size_t c = 0; c < mesh.volumes().size(); ++c)
      scattered += problem.scattering()[c * bands + band] * mesh.volumes()[c];
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      surface += mesh.area(FaceIndex(f)) *
                 (1 - mirrored_part_of_isotropic(problem.wall(mesh.wall(FaceIndex(f))), band));
    if (scattered > 0) most = std::max(most, 4 * scattered / surface);
  }
  return most;
}

/// Why diffusion would not pay; empty where it does.
std::string reason_to_do_without(const Problem& problem) {
  const double wall = brightest_wall(problem);
  if (const double part = std::max(wall, largest_albedo(problem)); part <= little_return)
    return fmt::format("cells and walls send back at most {:.2g} of the light", part);
  if (const double scatterings = scatterings_on_a_chord(problem);
      wall <= bright_wall && scatterings < few_scatterings)
    return fmt::format("light scatters only {:.2g} times on its way through", scatterings);
  return "";
}

/// Why a run is not accelerated; empty where it is.
std::string reason_against_acceleration(const Problem& problem, const SolveOptions& options) {
  if (options.acceleration == Acceleration::diffusion) return "";
  if (options.acceleration == Acceleration::none) return "as asked";
  if (options.method == Method::source_iteration)
    return "source iteration is plain unless diffusion is asked for";
  return reason_to_do_without(problem);
}

/// What knows how large an error is, and what makes it smaller: both are diffusion.
struct LowOrder {
  std::unique_ptr<DiffusionAcceleration> diffusion;  ///< null where the iteration itself knows well enough
  bool accelerates = false;

  DiffusionAcceleration* acceleration() const { return accelerates ? diffusion.get() : nullptr; }
  DiffusionAcceleration* judge() const { return accelerates ? nullptr : diffusion.get(); }
};

LowOrder make_low_order(const Problem& problem, TransportSweep& sweep, std::span<const double> extinction,
                        const SolveOptions& options, Solution& solution) {
  if (sweep.is_direct() || options.max_sweeps <= 2) return {};
  const std::string reason = reason_against_acceleration(problem, options);
  if (!reason.empty()) solution.notes.push_back("not accelerated: " + reason);
  // Where it would pay, residuals say little of the error.
  if (!reason.empty() && !reason_to_do_without(problem).empty()) return {};
  return {std::make_unique<DiffusionAcceleration>(problem, sweep, extinction, options.diffusion_length),
          reason.empty()};
}

std::string single_precision_note(const SingleTransportSweep& single) {
  return fmt::format("{} sweeps of a band in single precision, within cycles that double precision corrects",
                     single.band_sweep_count());
}

/// The solution is what a sweep gave and wrote down on its way.
void read_out(TransportSweep& sweep, const TransportState& last_state, SweepRecord& record,
              Solution& solution) {
  const auto bands = static_cast<std::size_t>(sweep.cells().bands());
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  const auto nodes = static_cast<std::size_t>(sweep.cells().nodes());
  const auto face_nodes = static_cast<std::size_t>(sweep.cells().face_nodes());
  solution.fluence = unpadded(last_state.fluence(), nodes, 4, stride, bands);
  solution.net_flux = net_flux_at_vertices(record.net_flux.span(), nodes, stride, bands);
  solution.irradiance = unpadded(last_state.irradiance(), face_nodes, 3, stride, bands);
  solution.exitance = unpadded(record.exitance.span(), face_nodes, 3, stride, bands);
  for (OrdinateRadiance& kept : record.radiance)
    solution.radiance.push_back({kept.ordinate, unpadded(kept.values, nodes, 4, stride, bands)});
  solution.meters = unpadded(record.meters, 1, 1, stride, bands);
  solution.state = saved(last_state, sweep.cells().bands());
  solution.absorbed = std::move(record.absorbed);
  for (std::size_t i = 0; i < solution.absorbed.size(); ++i) {
    const CellIndex cell(static_cast<std::int64_t>(i / bands));
    const int band = static_cast<int>(i % bands);
    if (sweep.discretization().dense.absorbs_by_direction(cell, band)) continue;
    double mean = 0;
    for (std::size_t node = 0; node < 4; ++node)
      mean += solution.fluence[(cell.at() * 4 + node) * bands + i % bands] / 4;
    solution.absorbed[i] = sweep.problem().absorption(cell, band) * mean;
  }
  solution.negative = negative_census(solution.fluence, bands);
}

/// From the state to the solution's, by as many sweeps as that takes; the last of them fills the record.
/// Throws SweepStopped, and then the state is the best so far.
void iterate(TransportSweep& sweep, SingleTransportSweep* single, const LowOrder& low_order,
             Iteration& iteration, const SolveOptions& options, const SolveObserver& observer,
             TransportState& state, SweepRecord& record, Solution& solution) {
  bool recorded = false;
  int used = 1;
  if (sweep.is_direct()) {
    solution.convergence.assign(static_cast<std::size_t>(sweep.problem().band_count()), {1, 0, true});
  } else if (options.max_sweeps == 1) {
    // The only sweep is the one that measures; nothing is known of its error.
    solution.convergence.assign(static_cast<std::size_t>(sweep.problem().band_count()), {1, 1, false});
  } else {
    used = low_order.diffusion ? low_order.diffusion->sweeps() : 0;
    // A sweep that measures is one of those that are allowed: the last of the iteration or one more.
    const bool records = iteration.records() && options.positivity == Positivity::none;
    if (!records) ++used;
    const IterationOptions limits{options.tolerance,
                                  options.max_sweeps - used,
                                  low_order.acceleration(),
                                  low_order.judge(),
                                  single,
                                  records ? &record : nullptr};
    IterationResult result = starts_positive(options) ? untouched(sweep.problem().band_count())
                                                      : iteration.run(sweep, state, limits, observer);
    solution.convergence = std::move(result.bands);
    solution.history = std::move(result.history);
    solution.interrupted = result.interrupted;
    recorded = result.recorded;
    if (records && !recorded) ++used;
    if (single) solution.notes.push_back(single_precision_note(*single));
    for (BandConvergence& band : solution.convergence) band.sweeps += used;
    used += result.sweeps;
    if (low_order.accelerates)
      for (std::string& note : low_order.diffusion->notes()) solution.notes.push_back(std::move(note));
    std::move(result.notes.begin(), result.notes.end(), std::back_inserter(solution.notes));
  }
  if (options.positivity != Positivity::none && options.order == SpaceOrder::linear)
    keep_positive(sweep, state, options, low_order.acceleration(), observer, used, solution);
  if (!recorded) {
    TransportState last_state(sweep.layout());
    sweep.apply(state, last_state, &record);
    check_finite(sweep, used, last_state);
    state = std::move(last_state);
  }
}

}  // namespace

Solution solve(const Problem& problem, const DirectionSet& directions, const SolveOptions& options,
               const SolveObserver& observer) try {
  if (problem.space() != directions.space())
    throw std::invalid_argument("a plane problem needs directions in the plane, and only that");
  using Clock = std::chrono::steady_clock;
  const auto seconds_between = [](Clock::time_point a, Clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
  };
  const Clock::time_point begun = Clock::now();
  const std::vector<double> extinction = extinction_of(problem);
  SolveOptions with_emission = options;
  const OrdinateLights lights(problem, directions, options.angular_input);
  if (!lights.empty()) with_emission.angular_input = &lights;
  const DirectionalEmission emission(problem, directions, with_emission.angular_input);
  if (!emission.empty()) with_emission.angular_input = &emission;
  TransportSweep sweep(problem, directions, extinction, with_emission);
  TransportState state(sweep.layout());
  if (options.initial != nullptr) restore(*options.initial, problem.band_count(), state);
  const std::unique_ptr<Iteration> iteration = make_iteration(options.method);
  Solution solution;
  solution.method = iteration->name();
  solution.directions = directions.count();

  const Clock::time_point start = Clock::now();
  solution.seconds.orders = sweep.order_seconds();
  solution.seconds.setup = seconds_between(begun, start) - solution.seconds.orders;
  std::optional<SingleTransportSweep> single;
  if (options.precision == Precision::mixed && options.method != Method::source_iteration &&
      !sweep.is_direct())
    single.emplace(sweep);
  LowOrder low_order;
  SweepRecord record;
  try {
    low_order = make_low_order(problem, sweep, extinction, options, solution);
    iterate(sweep, single ? &*single : nullptr, low_order, *iteration, options, observer, state, record,
            solution);
  } catch (const SweepStopped&) {
    throw SolveStopped{saved(state, problem.band_count())};
  }
  read_out(sweep, state, record, solution);
  if (low_order.diffusion) {
    solution.seconds.low_order_setup = low_order.diffusion->setup_seconds();
    solution.seconds.low_order = low_order.diffusion->seconds() + solution.seconds.low_order_setup;
  }
  solution.seconds.sweep = seconds_between(start, Clock::now()) - solution.seconds.low_order;
  solution.half_range = sweep.walls().emission_range();
  solution.by_direction = emission.powers();
  if (!lights.empty()) {
    solution.lights.inside = lights.power_inside();
    solution.lights.from_walls = lights.power_through_walls();
  }
  solution.kernels = report_kernels(problem, directions, sweep.discretization().scattering.plan,
                                    sweep.discretization().scattering.groups);
  const std::vector<std::string> notes = notes_of(sweep, options);
  solution.notes.insert(solution.notes.begin(), notes.begin(), notes.end());
  solution.fixups = fixups_of(sweep, directions);
  solution.lagged_faces = static_cast<int>(sweep.discretization().orders->lagged_total());
  const double swept = sweep.processor_seconds() + (single ? single->processor_seconds() : 0);
  const std::int64_t band_sweeps = sweep.band_sweep_count() + (single ? single->band_sweep_count() : 0);
  solution.sweep_cost =
      1e9 * swept / (static_cast<double>(band_sweeps) * problem.mesh().cell_count() * directions.count());
  return solution;
} catch (const SweepStopped&) {
  throw SolveStopped{};  // before there was a state
}

}  // namespace etendue
