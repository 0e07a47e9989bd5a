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
    settings_.order = input_.direction_order;
  }

  ExitCode made() {
    out_ << goal_text(accuracy_) << round_heading() << std::flush;
    std::optional<RoundSettings> accepted;
    while (true) {
      try {
        run_round(false);
        if (kept_) break;
        accepted = settings_;
        settings_ = *next_;
      } catch (const InputError& fault) {
        if (!accepted) throw;
        return_to(*accepted, fault.what());
        break;
      } catch (const std::bad_alloc&) {
        if (!accepted) throw;
        return_to(*accepted, "the memory of this machine does not suffice");
        break;
      }
    }
    return conclude();
  }

 private:
  /// The last round that was possible once more, for its results.
  void return_to(const RoundSettings& settings, const std::string& fault) {
    outcome_.why = "finer is not possible: " + fault.substr(0, fault.find('\n'));
    settings_ = settings;
    run_round(true);
  }

  void run_round(bool again) {
    code_ = run_if_wanted(
        round_request(settings_),
        [&](const RunResult& result) {
          if (again) return kept_ = true;
          note(result);
          return kept_;
        },
        out_, err_);
    if (code_ == ExitCode::interrupted) kept_ = true;
  }

  void note(const RunResult& result) {
    const AccuracyRound& round = rounds_.add(kept_of(result));
    if (rounds_.all().size() == 1) volume_ = total_volume(result.problem.mesh());
    out_ << round_line(round, static_cast<int>(rounds_.all().size()), accuracy_) << std::flush;
    outcome_.reached = round.is_accurate() && round.run.whole;
    kept_ = outcome_.reached || !round.run.whole;
    if (!round.run.whole) outcome_.why = "the last round did not converge, or was interrupted";
    if (kept_) return;
    next_ = next_settings();
    kept_ = !next_;
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
      outcome_.why =
          fmt::format("the next round would take about {:.0f} s, beyond the budget of {:.3g} minutes",
                      std::ceil(times * rounds_.all().back().run.seconds), accuracy_.minutes);
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
    const double affordable = std::cbrt(std::min(times_left(), memory_left()));
    if (affordable > least_useful_factor) factor = std::min(factor, affordable);
    next.cell_size /= factor;
    const double times = std::pow(factor, 3) * (1 - 1e-9);
    return is_affordable(times, times) ? std::optional(next) : std::nullopt;
  }

  std::optional<RoundSettings> finer_directions(double factor) {
    const KeptRun& last = rounds_.all().back().run;
    const double wanted = last.directions * (last.is_flat ? factor : factor * factor);
    RoundSettings next = settings_;
    for (int order = settings_.order + 1; order <= 2 * settings_.order + 2; ++order) {
      if (!check_direction_order(input_.direction_set, order).empty()) continue;
      next.order = order;
      const int count = build_directions(read_case(request_.file, overrides(next))).count();
      const double times = 1 + last.of_directions / last.seconds * (count / last.directions - 1);
      if (!is_affordable(times, 1)) break;
      if (count >= wanted) return next;
    }
    if (next.order > settings_.order && is_affordable(1, 1)) return next;
    if (outcome_.why.empty())
      outcome_.why = fmt::format("the direction set {} has no higher order", input_.direction_set);
    return std::nullopt;
  }

  Overrides overrides(const RoundSettings& settings) const {
    Overrides all = request_.overrides;
    all.push_back(fmt::format("directions.order={}", settings.order));
    if (accuracy_.sets_tolerance && accuracy_.relative)
      all.push_back(fmt::format("solve.tolerance={}", std::clamp(share_of_iteration * *accuracy_.relative,
                                                                 tightest_tolerance, loosest_tolerance)));
    all.emplace_back("output.checkpoint_every=0");
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
    return request;
  }

  ExitCode conclude() {
    if (rounds_.all().empty()) return code_;
    outcome_.seconds = seconds();
    const AccuracyRound& last = rounds_.all().back();
    const std::string text = estimate_text(last.estimate) + outcome_text(outcome_, last, accuracy_);
    out_ << text << std::flush;
    write_rounds(last.run.directory);
    append_to_log(last.run.directory, text);
    if (code_ == ExitCode::done && !outcome_.reached) {
      err_ << "the accuracy that is asked for was not reached; the results are those of the last round\n";
      return ExitCode::not_converged;
    }
    return code_;
  }

  void write_rounds(const std::filesystem::path& directory) const {
    if (is_known(rounds_.all().back().estimate)) write_estimate(rounds_.all().back().estimate, directory);
    Interruption interruption;
    interruption.note_all();  // the files become whole
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
  bool kept_ = false;  ///< whether the last round leaves its results
  ExitCode code_ = ExitCode::done;
  AccuracyOutcome outcome_;
};

}  // namespace

ExitCode run_to_accuracy(const RunRequest& request, std::ostream& out, std::ostream& err) {
  return AccuracyRun(request, out, err).made();
}

}  // namespace etendue
