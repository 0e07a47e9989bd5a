// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/solve_in_time.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/time/steps_in_time.h"
#include "app/time/time_numbers.h"
#include "base/vector_sums.h"
#include "base/wall_clock.h"
#include "solver/time/delayed_courses.h"
#include "solver/time/flight_moments.h"

namespace etendue {
namespace {

using Complex = std::complex<double>;

/// Inversion multiplies the errors that an iteration leaves by up to 250.
constexpr double tolerance_of_transforms = 1e-8;
/// Of the progress, where there are steps too.
constexpr double share_of_rates = 0.5;

/// Rates of the frequencies, that of the mean first.
std::vector<Complex> rates_of_frequencies(const std::vector<double>& frequencies) {
  std::vector<Complex> rates = {0.0};
  for (const double frequency : frequencies) rates.emplace_back(0, 2 * std::numbers::pi * frequency);
  return rates;
}

/// The transform of when everything emits.
Complex transform_of(const InTime& in_time, Complex rate) {
  return in_time.kind == InTime::Kind::step ? 1.0 / rate : 1.0;
}

std::size_t rate_count(const TimeCase& time) {
  return (time.modulation.empty() ? 0 : time.modulation.size() + 1) +
         latest_times(time.times).size() * LaplaceInversion::rate_count;
}

/// One run through the rates of a case.
class SolverInTime {
 public:
  SolverInTime(const TimeSetup& setup, const Solution& steady, const StageDisplay& stages,
               std::function<bool()> interrupted)
      : time_(*setup.input.time),
        setup_(setup),
        steady_(steady),
        slowness_(slowness_of(setup.input, setup.problem)),
        numbers_(setup.input, setup.problem, setup.locator),
        interrupted_(std::move(interrupted)),
        start_(WallClock::now()) {
    result_.quantities = numbers_.quantities();
    if (!setup.lights.empty()) {
      ShownStage stage(stages, "light in time along rays");
      uncollided_.emplace(setup.lights, slowness_, setup.uncollided, numbers_.timed_places(),
                          setup.options.threads, stage.observer());
    }
    stage_.emplace(stages, "light in time");
    result_.interrupted = is_interrupted();
  }

  TimeResult result() {
    if (!time_.modulation.empty() && !result_.interrupted) find_modulated();
    if (!time_.times.empty() && !result_.interrupted) find_histories();
    if (time_.flight_times && !result_.interrupted) find_flight_times();
    if (time_.until && !result_.interrupted) march();
    result_.seconds = seconds_since(start_);
    return std::move(result_);
  }

 private:
  /// Of moments over all sets of directions.
  void find_flight_times() {
    constexpr int highest = 2;
    std::vector<std::vector<double>> moments(highest + 1,
                                             std::vector<double>(numbers_.quantities().size(), 0));
    SolveOptions options = setup_.options;
    options.meters = numbers_.meters();
    options.stops = interrupted_;
    try {
      for (const DirectionSet& directions : setup_.sets)
        solve_flight_moments(
            setup_.problem, directions, slowness_, highest, options,
            [&](int k, const Problem& problem, const Solution& moment, const UncollidedValues* uncollided) {
              note(moment);
              std::vector<double>& sums = moments[static_cast<std::size_t>(k)];
              add_to(sums, numbers_.values(problem, moment));
              if (uncollided != nullptr) add_to(sums, numbers_.uncollided(*uncollided));
            },
            observe(), uncollided());
    } catch (const SolveStopped&) {
      result_.interrupted = true;
      return;
    }
    for (std::size_t q = 0; q < moments[0].size(); ++q) {
      const bool any = moments[0][q] > 0;
      const double mean = any ? moments[1][q] / moments[0][q] : 0;
      const double variance = any ? moments[2][q] / moments[0][q] - mean * mean : 0;
      result_.flight_times.push_back({mean, std::sqrt(std::max(0.0, variance))});
    }
  }

  void march() {
    const double before = rate_count(time_) > 0 ? share_of_rates : 0;
    take_steps(
        setup_, numbers_, steady_, uncollided(), interrupted_,
        [&](double share) { stage_->observer()(before + (1 - before) * share); }, result_);
  }

  void find_modulated() {
    const std::vector<Complex> rates = rates_of_frequencies(time_.modulation);
    solve(rates, setup_.options.tolerance, [&](const SolvedRates& solved) {
      std::vector<std::vector<Complex>> values = numbers_.read(solved);
      if (solved.uncollided != nullptr) {
        const std::vector<std::vector<Complex>> more = numbers_.uncollided(solved);
        for (std::size_t i = 0; i < values.size(); ++i)
          for (std::size_t q = 0; q < values[i].size(); ++q) values[i][q] += more[i][q];
      }
      for (std::size_t i = 0; i < solved.count; ++i) {
        const std::size_t place = solved.first + i;
        const double frequency = place == 0 ? 0 : time_.modulation[place - 1];
        result_.modulated.push_back({frequency, std::move(values[i]), fluence_of(solved, i)});
      }
    });
    if (result_.interrupted) result_.modulated.clear();
  }

  /// The fluence at one of the rates [cell][4][band][part].
  std::vector<double> fluence_of(const SolvedRates& solved, std::size_t rate) const {
    const std::size_t parts = 2 * static_cast<std::size_t>(setup_.problem.band_count());
    std::vector<double> all = solved.solution.fluence;
    if (solved.uncollided != nullptr) add_to(all, solved.uncollided->field.fluence);
    std::vector<double> fluence;
    for (std::size_t first = rate * parts; first < all.size(); first += solved.count * parts)
      fluence.insert(fluence.end(), all.begin() + static_cast<std::ptrdiff_t>(first),
                     all.begin() + static_cast<std::ptrdiff_t>(first + parts));
    return fluence;
  }

  void find_histories() {
    result_.histories.assign(result_.quantities.size(), std::vector<ValueInTime>(time_.times.size()));
    const std::vector<double> latest = latest_times(time_.times);
    auto end = time_.times.cend();
    for (std::size_t run = 0; run < latest.size() && !result_.interrupted; ++run) {
      const auto begin = run + 1 < latest.size()
                             ? std::upper_bound(time_.times.cbegin(), end, latest[run + 1])
                             : time_.times.cbegin();
      invert(LaplaceInversion(latest[run]), begin, end);
      end = begin;
    }
    if (result_.interrupted) result_.histories.clear();
  }

  /// Finds the histories of some neighbouring times.
  void invert(const LaplaceInversion& inversion, std::vector<double>::const_iterator begin,
              std::vector<double>::const_iterator end) {
    std::vector<std::vector<Complex>> transforms(result_.quantities.size());
    const double tolerance = std::min(setup_.options.tolerance, tolerance_of_transforms);
    solve(inversion.rates(), tolerance, [&](const SolvedRates& solved) {
      const std::vector<std::vector<Complex>> values = numbers_.read(solved);
      for (std::size_t i = 0; i < solved.count; ++i)
        for (std::size_t q = 0; q < transforms.size(); ++q)
          transforms[q].push_back(values[i][q] *
                                  transform_of(time_.in_time, inversion.rates()[solved.first + i]));
    });
    if (result_.interrupted) return;
    const std::span<const double> times(begin, end);
    const auto first = static_cast<std::size_t>(begin - time_.times.cbegin());
    for (std::size_t q = 0; q < transforms.size(); ++q) {
      const std::vector<ValueInTime> values = inversion.at(times, transforms[q], tolerance);
      std::ranges::copy(values, result_.histories[q].begin() + static_cast<std::ptrdiff_t>(first));
    }
    if (uncollided_) add_uncollided(times, first);
  }

  /// Adds light along rays at some times; after a pulse its mean over a window about each.
  void add_uncollided(std::span<const double> times, std::size_t first) {
    const EmissionCourses courses =
        one_course(setup_.problem, {time_.in_time.kind == InTime::Kind::pulse, [](double) { return 1.0; }});
    const DelayedCourses delayed(*uncollided_, courses, time_.times.back());
    UncollidedValues along_rays = uncollided_->at(delayed.at(0, 0));
    for (std::size_t i = 0; i < times.size(); ++i) {
      const TimeInterval window = window_about(times[i], time_);
      const bool is_pulse = courses.courses.front().is_pulse;
      uncollided_->set(is_pulse ? delayed.mean(window.begin, window.end) : delayed.at(0, times[i]),
                       along_rays);
      const std::vector<double> values = numbers_.uncollided(along_rays);
      for (std::size_t q = 0; q < values.size(); ++q) result_.histories[q][first + i].value += values[q];
    }
  }

  void solve(const std::vector<Complex>& rates, double tolerance,
             const std::function<void(const SolvedRates&)>& take) {
    SolveOptions options = setup_.options;
    options.meters = numbers_.meters();
    options.tolerance = tolerance;
    options.stops = interrupted_;
    try {
      solve_laplace(
          setup_.problem, setup_.sets, rates, slowness_, options,
          [&](const SolvedRates& solved) {
            note(solved);
            if (!result_.interrupted) take(solved);
            return !result_.interrupted;
          },
          observe(), uncollided());
    } catch (const SolveStopped&) {
      result_.interrupted = true;
    }
  }

  const UncollidedInTime* uncollided() const { return uncollided_ ? &*uncollided_ : nullptr; }

  /// Asked by one thread of each process, in the same order.
  bool is_interrupted() const { return any_of(setup_.options.ranks, interrupted_()); }

  SolveObserver observe() const {
    return [this](const SweepProgress&) {
      return is_interrupted() ? SolveControl::stop : SolveControl::proceed;
    };
  }

  void note(const Solution& solution) {
    for (const BandConvergence& band : solution.convergence) {
      result_.sweeps = std::max(result_.sweeps, band.sweeps);
      result_.residual = std::max(result_.residual, band.residual);
    }
    result_.converged = result_.converged && solution.converged();
  }

  void note(const SolvedRates& solved) {
    note(solved.solution);
    result_.interrupted = is_interrupted() || solved.solution.interrupted;
    result_.rates += static_cast<int>(solved.count);
    stage_->observer()((time_.until ? share_of_rates : 1) * static_cast<double>(result_.rates) /
                       static_cast<double>(rate_count(time_)));
  }

  const TimeCase& time_;
  const TimeSetup& setup_;
  const Solution& steady_;
  Slowness slowness_;
  TimeNumbers numbers_;
  std::function<bool()> interrupted_;
  WallClock::time_point start_;
  std::optional<UncollidedInTime> uncollided_;
  std::optional<ShownStage> stage_;
  TimeResult result_;
};

std::size_t rates_together(const TimeSetup& setup) {
  return rates_side_by_side(setup.problem, setup.sets.front(), rate_count(*setup.input.time), setup.options);
}

RunMemory memory_of_rates(const TimeSetup& setup, std::size_t together) {
  const std::vector<Complex> any(together, 0.0);
  const LaplaceProblem laplace =
      laplace_problem(setup.problem, any, Slowness(setup.problem.mesh().region_names().size(), 0));
  RunMemory memory = memory_of(LightSetup(laplace.problem), {setup.sets, {}}, setup.options);
  // Beside it are the steady solution, fluence, flux and state, and the fluence of each frequency, complex.
  const std::size_t fluences = 6 + 2 * (setup.input.time->modulation.size() + 1);
  const std::size_t more = fluences * 4 * sizeof(double) *
                           static_cast<std::size_t>(setup.problem.mesh().cell_count()) *
                           static_cast<std::size_t>(setup.problem.band_count());
  for (std::size_t* const of : {&memory.solving, &memory.expected})
    *of += more + memory_of_rays(setup, 2 * together);
  return memory;
}

}  // namespace

RunMemory time_memory(const TimeSetup& setup) {
  RunMemory memory;
  if (rate_count(*setup.input.time) > 0) memory = memory_of_rates(setup, rates_together(setup));
  if (!setup.input.time->until && !setup.input.time->flight_times) return memory;
  return larger_of(std::move(memory), steps_memory(setup));
}

std::string time_plan_text(const TimeSetup& setup) {
  std::string text;
  if (const std::size_t rates = rate_count(*setup.input.time); rates > 0) {
    const std::size_t together = rates_together(setup);
    text = fmt::format("light in time: {} rates are solved for, {} side by side\n", rates, together);
  }
  if (setup.input.time->flight_times) text += "times of flight: three solutions with the same coefficients\n";
  if (setup.input.time->until) text += steps_plan_text(setup);
  const TimeNumbers numbers(setup.input, setup.problem, setup.locator);
  if (!numbers.left_out().empty())
    text += fmt::format("  sensors that do not read it: {}\n", fmt::join(numbers.left_out(), ", "));
  if (!setup.lights.empty()) text += "  light before its first collision is followed along rays\n";
  return text;
}

TimeResult solve_in_time(const TimeSetup& setup, const Solution& steady, const StageDisplay& stages,
                         const std::function<bool()>& interrupted) {
  return SolverInTime(setup, steady, stages, interrupted).result();
}

}  // namespace etendue
