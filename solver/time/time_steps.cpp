// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/time_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/field_view.h"
#include "base/parallel/thread_count.h"
#include "base/vector_sums.h"
#include "solver/solution/added_extinction.h"
#include "solver/solution/balance.h"
#include "solver/time/angular_history.h"
#include "solver/time/collisions_in_time.h"
#include "solver/time/delayed_courses.h"
#include "solver/time/timed_sources.h"
#include "solver/transport/solve/solve.h"
#include "solver/transport/solve/transport_solver.h"

namespace etendue {
namespace {

/// Input that every cell has along every ordinate, for estimates.
struct EverywhereDirectional : AngularInput {
  void add_source(OrdinateIndex, CellIndex, std::span<double>) const override {}
  void add_inflow(OrdinateIndex, FaceIndex, std::span<double>) const override {}
};

/// Energy of a solution, [band].
struct Powers {
  std::vector<double> energy;  ///< of all light [power time]
  std::vector<double> net;     ///< emitted less absorbed less what leaves [power]
};

/// The numbers of one solution.
struct Reading {
  std::vector<double> values;
  std::vector<double> fluence;
  Powers powers;
};

/// (1 - a) x + a y, element by element.
std::vector<double> mixed(const std::vector<double>& x, const std::vector<double>& y, double a) {
  std::vector<double> result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = (1 - a) * x[i] + a * y[i];
  return result;
}

/// One march.
class March {
 public:
  /// `problem` and `courses` are of what is swept from its emission on.
  March(const Problem& problem, const DirectionSet& directions, const Slowness& slowness,
        const EmissionCourses& courses, const StepOptions& steps, const SolveOptions& options,
        CollisionsInTime* collisions, const DelayedCourses* delayed)
      : steps_(steps),
        directions_(directions),
        slowness_(slowness),
        sources_(problem, directions, courses),
        collisions_(collisions),
        delayed_(delayed),
        dark_(darkened(problem)),
        history_(problem, sources_, slowness, collisions != nullptr ? &collisions->input() : nullptr),
        options_(options) {
    options_.keep_ordinates = all_ordinates(directions);
    options_.angular_input = &history_;
    options_.initial = nullptr;
    last_.fluence = history_.begin(directions);
    last_.powers.energy = energy_of(last_.fluence);
    largest_fluence_ = norm(last_.fluence) > 0 ? norm(last_.fluence) : steps.scale;
    if (steps.read) {
      Solution dark = empty_solution();
      dark.fluence = last_.fluence;
      last_.values = steps.read(dark_, dark);
    }
  }

  void run(const TimeStepReader& reader, const SolveObserver& observer) {
    observer_ = observer;
    take_all_steps(steps_, [&](double begin, double length, double end) {
      return take_step(begin, length, end, reader);
    });
  }

 private:
  /// Takes a step, or leaves all as it was where its error is too large. The error; empty: the reader wants
  /// no more.
  std::optional<double> take_step(double begin, double step, double end, const TimeStepReader& reader) {
    sweeps_ = 0;
    residual_ = 0;
    converged_ = true;
    const bool by_differences = steps_.method == StepMethod::bdf2 && before_ && step == last_step_;
    const Taken taken = by_differences ? differences(begin, step, end) : stages(begin, step, end);
    const double largest = std::max(largest_fluence_, norm(taken.now.fluence));
    const double relative = largest > 0 ? norm(taken.error) / largest : 0;
    if (!steps_.accepts(relative)) {
      // What is too much may be far too much to begin from where there is hardly any light yet.
      solution_.state = accepted_;
      return relative;
    }
    accepted_ = solution_.state;
    history_.accept(std::move(solution_.radiance), steps_.method == StepMethod::bdf2);
    largest_fluence_ = std::max(largest_fluence_, norm(taken.now.fluence));
    std::vector<double> values = taken.now.values, energy = taken.now.powers.energy;
    if (collisions_ != nullptr) {
      collisions_->set(delayed_->at(begin, end));
      add_to(energy, energy_of(collisions_->values().field.fluence));
      if (steps_.read_uncollided) add_to(values, steps_.read_uncollided(collisions_->values()));
    }
    const TimeStep reached{begin,
                           end,
                           relative,
                           std::move(values),
                           taken.errors,
                           std::move(energy),
                           taken.energy_errors,
                           taken.imbalance,
                           sweeps_,
                           residual_,
                           converged_,
                           dark_,
                           solution_,
                           collisions_ != nullptr ? &collisions_->values() : nullptr};
    const bool goes_on = reader(reached);
    before_ = std::exchange(last_, taken.now);
    last_step_ = step;
    last_begin_ = begin;
    return goes_on ? std::optional<double>(relative) : std::nullopt;
  }

  /// What a step found.
  struct Taken {
    Reading now;
    std::vector<double> error;   ///< of the fluence
    std::vector<double> errors;  ///< of the values
    std::vector<double> energy_errors;
    double imbalance = 0;  ///< of the energy, of the worst band [power time]
  };

  /// k_1 at begin + gamma step and k_2 at the end; in first order it would be u + step k_1.
  Taken stages(double begin, double step, double end) {
    if (collisions_ != nullptr) collisions_->set(delayed_->mean(begin, end));
    history_.mix(1, 0);
    const Reading first = solve(sdirk_gamma * step, begin + sdirk_gamma * step);
    history_.keep_stage(std::move(solution_.radiance));
    history_.mix(1 - (1 - sdirk_gamma) / sdirk_gamma, (1 - sdirk_gamma) / sdirk_gamma);
    Taken taken{solve(sdirk_gamma * step, end), {}, {}, {}, 0};
    taken.error = differences_of(taken.now.fluence, mixed(last_.fluence, first.fluence, 1 / sdirk_gamma));
    taken.errors = differences_of(taken.now.values, mixed(last_.values, first.values, 1 / sdirk_gamma));
    taken.energy_errors = differences_of(taken.now.powers.energy,
                                         mixed(last_.powers.energy, first.powers.energy, 1 / sdirk_gamma));
    for (std::size_t b = 0; b < first.powers.net.size(); ++b) {
      const double gained =
          step * ((1 - sdirk_gamma) * first.powers.net[b] + sdirk_gamma * taken.now.powers.net[b]);
      taken.imbalance =
          std::max(taken.imbalance, std::abs(taken.now.powers.energy[b] - last_.powers.energy[b] - gained));
    }
    return taken;
  }

  Taken differences(double begin, double step, double end) {
    if (collisions_ != nullptr) collisions_->set(delayed_->extrapolated(last_begin_, begin, end));
    history_.mix(4.0 / 3, -1.0 / 3);
    Taken taken{solve(bdf2_part * step, end), {}, {}, {}, 0};
    const auto second = [](const std::vector<double>& now, const std::vector<double>& last,
                           const std::vector<double>& before) {
      std::vector<double> result(now.size());
      for (std::size_t i = 0; i < now.size(); ++i) result[i] = std::abs(now[i] - 2 * last[i] + before[i]) / 2;
      return result;
    };
    taken.error = second(taken.now.fluence, last_.fluence, before_->fluence);
    taken.errors = second(taken.now.values, last_.values, before_->values);
    taken.energy_errors = second(taken.now.powers.energy, last_.powers.energy, before_->powers.energy);
    for (std::size_t b = 0; b < taken.now.powers.net.size(); ++b) {
      const double change =
          1.5 * taken.now.powers.energy[b] - 2 * last_.powers.energy[b] + 0.5 * before_->powers.energy[b];
      taken.imbalance = std::max(taken.imbalance, std::abs(change - step * taken.now.powers.net[b]));
    }
    return taken;
  }

  static std::vector<double> differences_of(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<double> result(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) result[i] = std::abs(x[i] - y[i]);
    return result;
  }

  /// The light at a time, of the radiance that the history mixes, where a stage adds n / (c stage).
  Reading solve(double stage, double t) {
    use(stage);
    history_.set_time(stage, t);
    dark_.set_following(sources_.isotropic_at(t));
    solution_ = solver_->solve(observer_);
    int sweeps = 0;
    for (const BandConvergence& band : solution_.convergence) {
      sweeps = std::max(sweeps, band.sweeps);
      residual_ = std::max(residual_, band.residual);
    }
    sweeps_ += sweeps;
    if (solution_.interrupted) throw SolveStopped{};
    converged_ = converged_ && solution_.converged();
    Reading reading{{}, solution_.fluence, powers_of(t)};
    if (steps_.read) reading.values = steps_.read(dark_, solution_);
    return reading;
  }

  /// Makes the solver of a stage, unless it is at hand.
  void use(double stage) {
    if (solver_ && std::abs(stage - stage_) < alike_steps * stage) return;
    std::shared_ptr<const SweepOrders> orders;
    if (solver_) {
      orders = solver_->orders();
      initial_ = solution_.state;
      options_.initial = initial_.fluence.empty() ? nullptr : &initial_;
    }
    solver_.reset();
    const TetrahedralMesh& mesh = dark_.mesh();
    added_.real.clear();
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
      added_.real.insert(added_.real.end(), static_cast<std::size_t>(dark_.band_count()),
                         slowness_[static_cast<std::size_t>(mesh.region(CellIndex(c)))] / stage);
    options_.added_extinction = &added_;
    solver_ = std::make_unique<TransportSolver>(dark_, directions_, options_, std::move(orders));
    stage_ = stage;
  }

  Powers powers_of(double t) const {
    Powers powers{energy_of(solution_.fluence), sources_.power_inside(t)};
    if (collisions_ != nullptr) add_to(powers.net, first_scattered());
    for (const std::vector<RegionPower>& region : region_powers(dark_, solution_))
      for (std::size_t b = 0; b < powers.net.size(); ++b) powers.net[b] -= region[b].absorbed;
    for (const std::vector<WallPower>& wall : wall_powers(dark_, solution_))
      for (std::size_t b = 0; b < powers.net.size(); ++b)
        powers.net[b] += wall[b].outgoing - wall[b].incoming;
    return powers;
  }

  /// [band] What scatters in the domain for the first time [power].
  std::vector<double> first_scattered() const {
    const TetrahedralMesh& mesh = dark_.mesh();
    const auto bands = static_cast<std::size_t>(dark_.band_count());
    std::vector<double> power(bands, 0);
    for (std::size_t c = 0; c < static_cast<std::size_t>(mesh.cell_count()); ++c)
      for (std::size_t i = 0; i < 4 * bands; ++i)
        power[i % bands] += scattered_density(dark_, collisions_->values().field, c * 4 * bands + i) *
                            mesh.volume(CellIndex(static_cast<std::int64_t>(c))) / 4;
    return power;
  }

  std::vector<double> energy_of(const std::vector<double>& fluence) const {
    const TetrahedralMesh& mesh = dark_.mesh();
    const auto bands = static_cast<std::size_t>(dark_.band_count());
    std::vector<double> energy(bands, 0);
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const CellIndex cell(c);
      const double slow = slowness_[static_cast<std::size_t>(mesh.region(cell))];
      for (std::size_t b = 0; b < bands; ++b)
        energy[b] += slow * mesh.volume(cell) * ConstCellField(fluence, bands).mean(cell, b);
    }
    return energy;
  }

  double norm(const std::vector<double>& fluence) const { return rms_fluence(dark_, fluence); }

  /// With zeros where the fields of a solution are.
  Solution empty_solution() const {
    const auto bands = static_cast<std::size_t>(dark_.band_count());
    const auto cells = static_cast<std::size_t>(dark_.mesh().cell_count());
    const auto faces = static_cast<std::size_t>(dark_.mesh().boundary_face_count());
    Solution dark;
    dark.net_flux.assign(cells * 12 * bands, 0);
    dark.irradiance.assign(faces * 3 * bands, 0);
    dark.exitance.assign(faces * 3 * bands, 0);
    dark.half_range.assign(faces, 0);
    dark.meters.assign(options_.meters.size() * bands, 0);
    return dark;
  }

  const StepOptions& steps_;
  const DirectionSet& directions_;
  const Slowness& slowness_;
  TimedSources sources_;
  CollisionsInTime* collisions_;   ///< null: none
  const DelayedCourses* delayed_;  ///< of their light
  Problem dark_;
  AngularHistory history_;
  SolveOptions options_;
  SolveObserver observer_;
  AddedExtinction added_;
  SavedState initial_;   ///< of the solver
  SavedState accepted_;  ///< at the end of the last step; empty before
  std::unique_ptr<TransportSolver> solver_;
  double stage_ = 0;
  Solution solution_;
  Reading last_;                   ///< at the end of the last step
  std::optional<Reading> before_;  ///< of the step before
  double last_step_ = 0, last_begin_ = 0;
  double largest_fluence_ = 0;
  int sweeps_ = 0;  ///< of the step that is taken
  double residual_ = 0;
  bool converged_ = true;
};

}  // namespace

double rms_fluence(const Problem& problem, std::span<const double> fluence) {
  const TetrahedralMesh& mesh = problem.mesh();
  const std::size_t length = 4 * static_cast<std::size_t>(problem.band_count());
  double sum = 0, volume = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    double squares = 0;
    for (std::size_t i = 0; i < length; ++i)
      squares += std::pow(fluence[static_cast<std::size_t>(c) * length + i], 2);
    sum += squares * mesh.volume(CellIndex(c)) / static_cast<double>(length);
    volume += mesh.volume(CellIndex(c));
  }
  return std::sqrt(sum / volume);
}

void march_in_time(const Problem& problem, const DirectionSet& directions, const Slowness& slowness,
                   const EmissionCourses& courses, const StepOptions& steps, const SolveOptions& options,
                   const TimeStepReader& reader, const SolveObserver& observer,
                   const UncollidedInTime* uncollided) {
  if (uncollided == nullptr) {
    March(problem, directions, slowness, courses, steps, options, nullptr, nullptr).run(reader, observer);
    return;
  }
  CollisionsInTime collisions(*uncollided, directions, thread_count(options.threads));
  const DelayedCourses delayed(*uncollided, courses, steps.until);
  March(uncollided->remaining(), directions, slowness, remaining_courses(uncollided->lights(), courses),
        steps, options, &collisions, &delayed)
      .run(reader, observer);
}

std::size_t estimate_march_memory(const Problem& problem, const DirectionSet& directions,
                                  const SolveOptions& options, KrylovVectors vectors) {
  SolveOptions own = options;
  own.keep_ordinates = all_ordinates(directions);
  const EverywhereDirectional input;
  own.angular_input = &input;
  const std::size_t angular = static_cast<std::size_t>(problem.mesh().cell_count()) * 4 *
                              static_cast<std::size_t>(problem.band_count()) *
                              static_cast<std::size_t>(directions.count()) * sizeof(double);
  return estimate_memory(problem, directions, own, vectors) + 2 * angular;
}

}  // namespace etendue
