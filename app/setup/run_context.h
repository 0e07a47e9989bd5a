// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/progress/interruption.h"
#include "app/progress/stage_progress.h"
#include "app/request/commands.h"
#include "app/write/results.h"
#include "base/log.h"

namespace etendue {

class Stopwatch {
 public:
  /// Since the last call, or since it was made.
  double lap() {
    const auto now = Clock::now();
    return seconds_between(std::exchange(lap_, now), now);
  }
  double total() const { return seconds_between(start_, Clock::now()); }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_between(Clock::time_point a, Clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
  }
  Clock::time_point start_ = Clock::now();
  Clock::time_point lap_ = start_;
};

/// Inputs that all methods of a run share: its request, case, problem and progress.
struct RunContext {
  const RunRequest& request;
  const Case& input;
  const Problem& problem;
  RunSeconds seconds;
  Stopwatch& watch;
  Interruption& interruption;
  std::ostream& shown;  ///< progress goes here, even where nothing is described
};

/// The case of a request, with what that leaves out.
Case case_of(const RunRequest& request);

/// The mesh of a case and the files of a result, shown where they take long.
TetrahedralMesh mesh_visibly(const Case& input, const Log& log, const StageDisplay& stages);
WrittenResults write_visibly(const RunResult& result, const StageDisplay& stages);

/// How an interrupted run continues from the solution.vtu that it left; ends with a line break.
std::string how_to_go_on(const Case& input);

/// The threads of a run, those that are wanted or all cores.
int thread_count(const Case& input);

/// Behind the number of threads: in how many processes; empty where this one is alone.
std::string ranks_text(const RankGroup* ranks);
/// The processes that shared a run so far.
std::optional<RunRanks> run_ranks(const RankGroup* ranks);

/// What a run by another method than directions came to, so far as all methods have it. `solution` must
/// outlive the result.
RunResult result_of(const RunContext& run, const Solution& solution, std::vector<ProbeRow> probes,
                    int threads);

/// Notes the probes and sensors of the case that a result has not: a signal left them out.
void note_left_out(RunResult& result);

/// The exit code of a run that has written its results, with the line on standard error that goes with one
/// other than 0.
ExitCode conclude(const RunResult& result, bool interrupted, std::ostream& err);
/// The end of a run in a process that does not write what another one does, once that has written it.
ExitCode conclude_beside(const RunResult& result, const ResultReader& reader,
                         const Interruption& interruption, RankGroup* ranks);
/// The end of a run that leaves nothing: its reader has the result.
ExitCode conclude_without_traces(const RunResult& result, const ResultReader& reader);

// The runs that do without directions. Results are written and described; `reader` is given them.
ExitCode run_by_photons(const RunContext& run, std::ostream& out, std::ostream& err,
                        const ResultReader& reader);
ExitCode run_by_radiosity(const RunContext& run, std::ostream& out, std::ostream& err,
                          const ResultReader& reader);

}  // namespace etendue
