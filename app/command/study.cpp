// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/study.h"

#include <fmt/format.h>

#include <exception>

#include "app/command/commands.h"
#include "app/command/study_level.h"
#include "app/write/output_folder.h"

namespace etendue {
namespace {

/// A level that is still to be run, or was.
struct Level {
  RunRequest request;
  Case input;
};

/// All levels as cases: what is wrong with one is known before the first is run.
std::vector<Level> read_levels(const StudyRequest& study, const Case& input) {
  std::vector<Level> levels;
  for (int level = 1; level <= study.levels; ++level) {
    RunRequest request = level_request(study, input, level);
    Case refined = read_case(request.file, request.overrides);
    levels.push_back({std::move(request), std::move(refined)});
  }
  return levels;
}

/// Runs the levels one after the other and keeps what those that end well came to.
class Study {
 public:
  Study(const StudyRequest& request, std::ostream& out, std::ostream& err)
      : request_(request), out_(out), err_(err) {}

  void run(const std::vector<Level>& levels) {
    for (std::size_t i = 0; i < levels.size() && code_ != ExitCode::interrupted; ++i)
      take(levels[i], static_cast<int>(i) + 1);
  }

  const std::vector<LevelResult>& results() const { return results_; }
  ExitCode code() const { return code_; }

 private:
  void take(const Level& level, int number) {
    const std::string heading = fmt::format("level {} of {}", number, request_.levels);
    if (request_.resume)
      if (auto saved = saved_level(level.input, number, request_.refinement)) {
        out_ << heading << ": kept from an earlier study (" << level.input.output.directory.string() << ")\n";
        if (!saved->converged) note(ExitCode::not_converged);
        results_.push_back(std::move(*saved));
        return;
      }
    out_ << heading << '\n';
    try {
      note(run_case(level.request, out_, err_, [&](const RunResult& run) {
        LevelResult result = level_result(run, number, request_.refinement);
        if (!run.solution.interrupted) save_level(result, level.input, request_.refinement);
        results_.push_back(std::move(result));
      }));
    } catch (const std::exception& error) {
      err_ << heading << " failed: " << error.what() << '\n';
      note(ExitCode::not_converged);
    }
    out_ << std::endl;
  }

  void note(ExitCode code) {
    if (code != ExitCode::done && code_ != ExitCode::interrupted) code_ = code;
  }

  const StudyRequest& request_;
  std::ostream& out_;
  std::ostream& err_;
  std::vector<LevelResult> results_;
  ExitCode code_ = ExitCode::done;
};

}  // namespace

ExitCode study_case(const StudyRequest& request, std::ostream& out, std::ostream& err) {
  const Case input = read_case(request.run.file, request.run.overrides);
  check_output_directory(input.output.directory);
  const std::vector<Level> levels = read_levels(request, input);
  Study study(request, out, err);
  study.run(levels);

  const std::vector<StudyRow> rows = study_rows(study.results(), request.refinement);
  OutputFolder folder(input.output.directory);
  folder.add_text("study.csv", study_csv(rows, request.refinement));
  folder.add_text("study.json", study_json(rows, request.refinement, input));
  folder.publish({});
  out << study_text(rows, study.results(), request.refinement) << "written to "
      << input.output.directory.string() << ": study.csv study.json\n";
  return study.code();
}

}  // namespace etendue
