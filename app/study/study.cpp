// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/study.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <optional>

#include "app/progress/interruption.h"
#include "app/request/commands.h"
#include "app/setup/deprecation_notes.h"
#include "app/setup/memory.h"
#include "app/study/study_forecast.h"
#include "app/study/study_level.h"
#include "app/study/study_plot.h"
#include "app/study/study_trust.h"
#include "app/write/json/summary.h"
#include "app/write/result/fluence_distance.h"
#include "app/write/result/output_folder.h"

namespace etendue {
namespace {

/// A level that is still to be run, or was.
struct Level {
  RunRequest request;
  std::optional<Case> input;  ///< nothing if it is refused
  std::string problem;        ///< why
};

/// All levels as cases: what is wrong with one is known before the first is run. Some of the later ones may
/// be refused, as orders that a set of directions does not have.
std::vector<Level> read_levels(const StudyRequest& study, const Case& input) {
  std::vector<Level> levels;
  for (int number = 1; number <= level_count(study); ++number) {
    Level& level = levels.emplace_back();
    level.request = level_request(study, input, number);
    try {
      level.input = read_case(level.request.file, level.request.overrides);
    } catch (const InputError& error) {
      if (number == 1) throw;
      level.problem = error.what();
    }
  }
  return levels;
}

void write_tables(const StudyRequest& request, const Case& input, const std::vector<StudyRow>& rows,
                  const std::vector<StudyTrust>& trust, const std::vector<StudyFailure>& failures) {
  OutputFolder folder(input.output.directory);
  folder.add_text("study.csv", study_csv(rows, request.refinement));
  folder.add_text("study.json", study_json(rows, request.refinement, input, failures, trust));
  folder.publish({"study.csv", "study.json", "study.svg"});
}

/// A level's bands, in order.
std::vector<std::string> bands_of(const LevelResult& result) {
  std::vector<std::string> bands;
  for (const StudyValue& value : result.values)
    if (value.quantity == "balance") bands.push_back(value.band);
  return bands;
}

void add_distances(const std::vector<FluenceError>& errors, LevelResult& result) {
  const std::vector<std::string> bands = bands_of(result);
  std::vector<StudyValue> norms;
  for (std::size_t band = 0; band < errors.size() && band < bands.size(); ++band) {
    norms.push_back({bands[band], "fluence_L2", errors[band].l2, {}});
    norms.push_back({bands[band], "fluence_Linf", errors[band].linf, {}});
  }
  result.values.insert(result.values.begin(), norms.begin(), norms.end());
}

/// Runs the levels one after the other and keeps what those that end well came to.
class Study {
 public:
  Study(const StudyRequest& request, std::ostream& out, std::ostream& err)
      : request_(request), out_(out), err_(err) {
    restart_peak_memory();
    floor_ = static_cast<double>(peak_memory());
    out_ << plan_text(request);
  }

  /// Whether there is a next level.
  bool goes_on() const { return code_ != ExitCode::interrupted; }

  void take(const Level& level, int number) {
    const std::string heading = fmt::format("level {} of {}", number, level_count(request_));
    if (!level.input) {
      fail(number, heading, level.problem);
      return say_what_is_left(number);
    }
    if (request_.resume && keep_saved(*level.input, number, heading)) return say_what_is_left(number);
    if (const auto forecast = forecast_after(number - 1); !forecast.empty())
      if (const std::string refusal = refusal_of(forecast.front(), installed_memory()); !refusal.empty())
        return fail(number, heading, refusal);
    out_ << heading << '\n';
    restart_peak_memory();
    try {
      note(run_case(level.request, out_, err_, [&](const RunResult& run) {
        if (run.solution.interrupted) return;
        LevelResult result = level_result(run, number, request_.refinement);
        save_level(result, *level.input, request_.refinement);
        results_.push_back(std::move(result));
      }));
    } catch (const std::bad_alloc&) {
      fail(number, heading, out_of_memory_message());
    } catch (const std::exception& error) {
      fail(number, heading, error.what());
    }
    say_what_is_left(number);
    out_ << std::endl;
  }

  /// Where nothing is exact, the norms of what the fluence of each level is off the finest level's.
  void compare_fields(const std::vector<Level>& levels) {
    const LevelResult* const finest = finest_of(results_);
    if (levels.front().input->exact || results_.size() < 2 || finest == nullptr) return;
    const auto fields_of = [&](const LevelResult& result) {
      return levels[static_cast<std::size_t>(result.level) - 1].input->output.directory / "fields.vtu";
    };
    for (LevelResult& result : results_)
      add_distances(&result == finest ? std::vector<FluenceError>(bands_of(result).size())
                                      : fluence_distance(fields_of(result), fields_of(*finest)),
                    result);
  }

  const std::vector<LevelResult>& results() const { return results_; }
  const std::vector<StudyFailure>& failures() const { return failures_; }
  ExitCode code() const { return code_; }

 private:
  bool keep_saved(const Case& input, int number, const std::string& heading) {
    std::optional<LevelResult> saved = saved_level(input, number, request_.refinement);
    if (!saved) return false;
    out_ << heading << ": kept from an earlier study (" << input.output.directory.string() << ")\n";
    if (!saved->converged) note(ExitCode::not_converged);
    results_.push_back(std::move(*saved));
    return true;
  }

  /// Of the levels after this one, by the last that ended well.
  std::vector<LevelForecast> forecast_after(int number) const {
    if (results_.empty()) return {};
    return forecast_levels(request_, results_.back(), floor_, number);
  }

  void say_what_is_left(int number) { out_ << forecast_text(forecast_after(number), level_count(request_)); }

  void fail(int number, const std::string& heading, const std::string& problem) {
    err_ << heading << " failed: " << problem << '\n';
    failures_.push_back({number, problem});
    note(ExitCode::not_converged);
  }

  void note(ExitCode code) {
    if (code != ExitCode::done && code_ != ExitCode::interrupted) code_ = code;
  }

  const StudyRequest& request_;
  std::ostream& out_;
  std::ostream& err_;
  double floor_ = 0;  ///< memory of the program before the first level [bytes]
  std::vector<LevelResult> results_;
  std::vector<StudyFailure> failures_;
  ExitCode code_ = ExitCode::done;
};

/// Which levels are done, where they are, and how to go on.
std::string interrupted_text(const StudyRequest& request, const Case& input, const Study& study) {
  std::string done;
  for (const LevelResult& result : study.results())
    done += fmt::format("{}level-{}", done.empty() ? "" : ", ", result.level);
  return fmt::format(
      "interrupted: of {} levels {} done, in {} with study.csv and study.json; to go on: the same command "
      "with --resume\n",
      level_count(request), done.empty() ? "none is" : done + (study.results().size() == 1 ? " is" : " are"),
      input.output.directory.string());
}

}  // namespace

ExitCode study_case(const StudyRequest& request, std::ostream& out, std::ostream& err) {
  const Case input = read_case(request.run.file, request.run.overrides);
  write_deprecations(input, err);
  check_output_directory(input.output.directory);
  const std::vector<Level> levels = read_levels(request, input);
  Study study(request, out, err);
  std::vector<StudyRow> rows;
  std::vector<StudyTrust> trust;
  const auto tabulate = [&] {
    rows = study_rows(study.results(), request.refinement, request.against);
    trust = study_trust(rows, study.results(), request.refinement);
    write_tables(request, input, rows, trust, study.failures());
  };
  const auto report = [&] {
    return study_text(rows, study.results(), request.refinement, study.failures()) +
           expectation_text(input, request.refinement) +
           trust_text(trust, study.results(), request.refinement, level_count(request));
  };
  for (std::size_t i = 0; i < levels.size() && study.goes_on(); ++i) {
    // A study that is ended early leaves the table of what there is, and shows it.
    std::optional<EarlierResults> so_far;
    if (!study.results().empty()) so_far.emplace("\n" + report() + interrupted_text(request, input, study));
    study.take(levels[i], static_cast<int>(i) + 1);
    tabulate();
  }
  study.compare_fields(levels);
  tabulate();
  out << report();
  const std::string no_plot = request.plot ? draw_study(input.output.directory) : "not asked for";
  out << "written to " << input.output.directory.string() << ": study.csv study.json"
      << (no_plot.empty() ? " study.svg\n" : "\n");
  if (request.plot && !no_plot.empty()) out << "no plot: " << no_plot << '\n';
  if (!study.goes_on()) {
    out << std::flush;
    err << interrupted_text(request, input, study);
  }
  return study.code();
}

}  // namespace etendue
