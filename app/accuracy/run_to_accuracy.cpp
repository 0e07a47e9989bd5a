// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <new>
#include <optional>

#include "app/accuracy/accuracy_round.h"
#include "app/accuracy/accuracy_tables.h"
#include "app/case/build/build.h"
#include "app/compare/estimate_files.h"
#include "app/progress/interruption.h"
#include "app/request/commands.h"
#include "app/run/report/run_log.h"
#include "app/setup/memory.h"
#include "app/study/study_level.h"
#include "app/write/json/summary.h"
#include "app/write/result/output_folder.h"
#include "base/errors.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

/// What the iteration may leave, of the relative error that is asked for.
constexpr double share_of_iteration = 0.01;
constexpr double loosest_tolerance = 1e-4, tightest_tolerance = 1e-9;
/// A refinement by less than this is not worth a run.
constexpr double least_useful_factor = 1.2;
/// Cells of a geometry without a size are at first as coarse as it lets them be. Of a tetrahedron with equal
/// sides a of volume V: a^3 = 6 sqrt(2) V.
const double edge_of_unit_volume = std::cbrt(6 * std::sqrt(2.0));

/// Throws InputError where the case has what rounds cannot be made with. Other commands may take it.
void check_possible(const Case& input) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fault_at(input.accuracy->origin, "", why));
  };
  if (input.photons) refuse("is of discrete ordinates; by photons solve.until ends a run at an error");
  if (input.radiosity) refuse("is of discrete ordinates; radiosity has radiosity.refine_change");
  if (input.initial) refuse("begins on coarse cells, for which solve.initial has no solution");
}

/// How a round differs from the case.
struct RoundSettings {
  double cell_size = 1;  ///< a multiple of the size in the case, or of the first round's where it has none
  int splits = 0;        ///< of cells that are read from a file
  int order = 0;         ///< of the directions
};

/// The rounds of one case.
class AccuracyRun {
 public:
  AccuracyRun(const RunRequest& request, std::ostream& out, std::ostream& err)
      : request_(request),
        input_(read_case(request.file, request.overrides)),
        accuracy_(*input_.accuracy),
        rounds_(accuracy_),
        out_(out),
        err_(err) {
    check_possible(input_);
    settings_.order = input_.direction_order;
  }

  ExitCode made() {
    out_ << goal_text(accuracy_) << round_heading() << std::flush;
    std::optional<EarlierResults> earlier;
    note_signals();
    while (!is_last_) {
      try {
        run_round();
      } catch (const InputError& fault) {
        if (rounds_.all().empty()) throw;
        end_with_the_last(fault.what());
      } catch (const NotFiniteError& fault) {
        if (rounds_.all().empty()) throw;
        end_with_the_last(fault.what());
      } catch (const std::bad_alloc&) {
        if (rounds_.all().empty()) throw;
        end_with_the_last("the memory of this machine does not suffice");
      }
      if (is_last_) break;
      outcome_.why = "it ended before the next round did";
      write_rounds();
      if (between_->noted()) {
        end_interrupted();
        break;
      }
      outcome_.why.clear();
      between_.reset();
      earlier.reset();
      earlier.emplace(interrupted_text());
      note_signals();
      settings_ = *next_;
    }
    const ExitCode code = conclude();
    between_.reset();  // before the words of earlier results
    return code;
  }

 private:
  /// Between the runs, whose own signals they decide on: files of rounds become whole.
  void note_signals() {
    between_.emplace();
    between_->note_all();
  }

  void end_interrupted() {
    err_ << interrupted_text().substr(1);
    code_ = ExitCode::interrupted;
    is_last_ = true;
  }

  std::string interrupted_text() const {
    return fmt::format("\ninterrupted: the results are those of round {}\n", rounds_.all().size());
  }

  /// A finer round is not possible: the results are those that the one before it left, without pictures.
  void end_with_the_last(const std::string& fault) {
    outcome_.why = "finer is not possible: " + fault.substr(0, fault.find('\n'));
    if (!input_.cameras.empty()) outcome_.why += "; `etendue render` takes the pictures";
    code_ = ExitCode::done;
    is_last_ = true;
  }

  void run_round() {
    refused_.clear();
    const std::size_t before = rounds_.all().size();
    code_ = run_judged(
        round_request(settings_), [&](const RunResult& result) { return use_of(result); }, out_, err_);
    if (rounds_.all().size() > before) {
      is_last_ |= code_ == ExitCode::interrupted;
    } else if (!refused_.empty()) {
      end_with_the_last(refused_);
    } else if (before > 0) {
      outcome_.why = "a signal ended it";
      end_interrupted();
    } else {
      is_last_ = true;  // of the first round nothing is there
    }
  }

  ResultUse use_of(const RunResult& result) {
    KeptRun run = kept_of(result);
    // What an earlier round left is worth more than what has not converged.
    if (!rounds_.all().empty()) {
      if (result.interrupted()) return ResultUse::none;
      if (!run.whole)
        refused_ = fmt::format("the next round did not converge within solve.max_sweeps = {}",
                               input_.solve.max_sweeps);
      if (run.numbers.size() != rounds_.all().back().run.numbers.size())
        refused_ = "the next round has other numbers";
      if (!refused_.empty()) return ResultUse::none;
    }
    note(std::move(run), result.problem.mesh());
    return is_last_ ? ResultUse::all : ResultUse::files;
  }

  void note(KeptRun run, const TetrahedralMesh& mesh) {
    const AccuracyRound& round = rounds_.add(std::move(run));
    if (rounds_.all().size() == 1) volume_ = total_volume(mesh);
    out_ << round_line(round, static_cast<int>(rounds_.all().size()), accuracy_) << std::flush;
    outcome_.reached = round.is_accurate() && round.run.whole;
    is_last_ = outcome_.reached || !round.run.whole;
    if (!round.run.whole) outcome_.why = "the first round did not converge, or a signal ended it";
    if (is_last_) return;
    next_ = next_settings();
    is_last_ = !next_;
  }

  static double total_volume(const TetrahedralMesh& mesh) {
    double volume = 0;
    for (const double cell : mesh.volumes()) volume += cell;
    return volume;
  }

  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  }

  /// Empty where the larger part cannot be refined: the smaller part alone would not reach the accuracy.
  std::optional<RoundSettings> next_settings() {
    const double tolerance = rounds_.all().back().run.tolerance;
    if (rounds_.excess_of_iteration() >= 1 && !(accuracy_.sets_tolerance && rounds_.all().size() == 1)) {
      outcome_.why =
          fmt::format("the iteration alone leaves more than that with solve.tolerance = {:g}", tolerance);
      return std::nullopt;
    }
    const NextRefinement wanted = rounds_.next();
    return wanted.what == Refined::cells ? finer_cells(wanted.factor) : finer_directions(wanted.factor);
  }

  /// How many times the time of the last round is left of the budget.
  double times_left() const {
    return (60 * accuracy_.minutes - seconds()) / std::max(1e-3, rounds_.all().back().run.seconds);
  }
  /// [bytes] that a round may take by its forecast.
  double allowed_memory() const {
    return std::min(accuracy_.memory_gb ? 1e9 * *accuracy_.memory_gb : HUGE_VAL, installed_memory());
  }
  double memory_left() const { return allowed_memory() / std::max(1.0, rounds_.all().back().run.memory); }

  /// A round that takes so many times the time and the memory of the last; else says why it cannot be.
  bool is_affordable(double times, double times_of_memory) {
    if (times > times_left())
      outcome_.why = fmt::format(
          "the next round would take about {:.0f} s, and {:.0f} s are left of the budget of {:.3g} minutes",
          std::ceil(times * rounds_.all().back().run.seconds),
          std::max(0.0, 60 * accuracy_.minutes - seconds()), accuracy_.minutes);
    else if (times_of_memory > memory_left())
      outcome_.why =
          fmt::format("the next round may take {:.3g} GB, beyond the {:.3g} GB that it may have",
                      times_of_memory * rounds_.all().back().run.memory / 1e9, allowed_memory() / 1e9);
    else
      return true;
    return false;
  }

  std::optional<RoundSettings> finer_cells(double factor) {
    RoundSettings next = settings_;
    if (input_.mesh.file) {
      ++next.splits;
      return is_affordable(8, 8) ? std::optional(next) : std::nullopt;
    }
    const double dimensions = rounds_.all().back().run.is_flat ? 2 : 3;
    const double affordable = std::pow(std::min(times_left(), memory_left()), 1 / dimensions);
    if (affordable > least_useful_factor) factor = std::min(factor, affordable);
    next.cell_size /= factor;
    const double times = std::pow(factor, dimensions) * (1 - 1e-9);
    return is_affordable(times, times) ? std::optional(next) : std::nullopt;
  }

  std::optional<RoundSettings> finer_directions(double factor) {
    const KeptRun& last = rounds_.all().back().run;
    const double wanted = last.directions * (last.is_flat ? factor : factor * factor);
    Case finer = input_;
    std::optional<RoundSettings> next;
    for (int order = settings_.order + 1; order <= 2 * settings_.order + 2; ++order) {
      if (!check_direction_order(input_.direction_set, order).empty()) continue;
      finer.direction_order = order;
      const int count = build_directions(finer).count();
      const double times = 1 + last.of_directions / last.seconds * (count / last.directions - 1);
      if (!is_affordable(times, 1)) return next;
      next = settings_;
      next->order = order;
      if (count >= wanted) return next;
    }
    if (!next) outcome_.why = fmt::format("the direction set {} has no higher order", input_.direction_set);
    return next;
  }

  /// That is asked for; of an absolute one that of the largest number, once there is one.
  double relative_error() const {
    if (accuracy_.relative) return *accuracy_.relative;
    double largest = 0;
    if (!rounds_.all().empty())
      for (const std::size_t i : rounds_.all().front().asked)
        largest = std::max(largest, std::abs(rounds_.all().front().run.numbers[i].value));
    return largest > 0 ? *accuracy_.absolute / largest : 1;
  }

  Overrides overrides(const RoundSettings& settings) const {
    Overrides all = request_.overrides;
    all.push_back(fmt::format("directions.order={}", settings.order));
    if (accuracy_.sets_tolerance)
      all.push_back(fmt::format("solve.tolerance={}", std::clamp(share_of_iteration * relative_error(),
                                                                 tightest_tolerance, loosest_tolerance)));
    if (settings.splits > 0) all.push_back(split_mesh(input_, settings.splits));
    if (settings.cell_size == 1) return all;
    if (input_.mesh.max_volume || input_.mesh.edge_length)
      all.push_back(resized_mesh(input_, settings.cell_size));
    else
      all.push_back(fmt::format(
          "mesh.edge_length={}",
          settings.cell_size * edge_of_unit_volume * std::cbrt(volume_ / rounds_.all().front().run.cells)));
    return all;
  }

  RunRequest round_request(const RoundSettings& settings) const {
    RunRequest request = request_;
    request.overrides = overrides(settings);
    if (!rounds_.all().empty()) request.traces = RunTraces::whole;
    return request;
  }

  ExitCode conclude() {
    if (rounds_.all().empty()) return code_;
    const AccuracyRound& last = rounds_.all().back();
    write_rounds();
    const std::string text = estimate_text(last.estimate) + outcome_text(outcome_, last, accuracy_);
    out_ << text << std::flush;
    append_to_log(last.run.directory, "\n" + rounds_text() + text);
    if (code_ == ExitCode::done && !outcome_.reached) {
      err_ << "the accuracy that is asked for was not reached; the results are those of the last round\n";
      return ExitCode::not_converged;
    }
    return code_;
  }

  /// All that was shown of the rounds.
  std::string rounds_text() const {
    std::string text = goal_text(accuracy_) + round_heading();
    int index = 0;
    for (const AccuracyRound& round : rounds_.all()) text += round_line(round, ++index, accuracy_);
    return text;
  }

  /// Beside the results of the last round.
  void write_rounds() {
    outcome_.seconds = seconds();
    const std::filesystem::path& directory = rounds_.all().back().run.directory;
    if (is_known(rounds_.all().back().estimate)) write_estimate(rounds_.all().back().estimate, directory);
    OutputFolder folder(directory);
    folder.lock();
    if (holds_other_run(directory)) return;
    folder.add_text("accuracy.csv", accuracy_csv(rounds_.all(), accuracy_));
    folder.add_text("summary.json",
                    summary_with_accuracy(directory, accuracy_json(outcome_, rounds_.all(), accuracy_)));
    folder.publish({});
  }

  const RunRequest& request_;
  const Case input_;
  const AccuracyCase& accuracy_;
  AccuracyRounds rounds_;
  std::ostream& out_;
  std::ostream& err_;
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  RoundSettings settings_;
  std::optional<RoundSettings> next_;
  double volume_ = 0;  ///< of the mesh of the first round
  std::optional<Interruption> between_;
  bool is_last_ = false;  ///< whether no other round follows
  std::string refused_;   ///< why the last run is no round; empty: it is one, or a signal ended it
  ExitCode code_ = ExitCode::done;
  AccuracyOutcome outcome_;
};

}  // namespace

ExitCode run_to_accuracy(const RunRequest& request, std::ostream& out, std::ostream& err) {
  return AccuracyRun(request, out, err).made();
}

}  // namespace etendue
