// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <ostream>

#include "app/request/command_line.h"
#include "app/request/exit_code.h"
#include "app/write/result/run_result.h"

namespace etendue {

// One function for each command. What people read goes to `out`; `err` takes the mesher's log where it was
// asked for and the line that says why the exit code is not 0. They throw as the rooms below do.

/// Called with the results of a run when they are written.
using ResultReader = std::function<void(const RunResult&)>;

ExitCode run_case(const RunRequest& request, std::ostream& out, std::ostream& err,
                  const ResultReader& reader = {});
/// What becomes of the results of a run: nothing, their files without pictures, or all as of run_case().
enum class ResultUse { none, files, all };
/// Decides from all numbers of a run, before anything is written.
using ResultJudge = std::function<ResultUse(const RunResult&)>;
/// run_case() by ordinates with a judge. Unless all is wanted, only the progress is shown.
ExitCode run_judged(const RunRequest& request, const ResultJudge& judge, std::ostream& out,
                    std::ostream& err);
/// The runs of a case with [accuracy], of which the last leaves its results.
ExitCode run_to_accuracy(const RunRequest& request, std::ostream& out, std::ostream& err);
/// run_case(), and where that is wanted or cheap the run again on coarser cells and with other directions,
/// for an estimate of the errors of its numbers.
ExitCode run_and_estimate(const RunRequest& request, std::ostream& out, std::ostream& err);
ExitCode render_results(const RenderRequest& request, std::ostream& out, std::ostream& err);
ExitCode bake_results(const BakeRequest& request, std::ostream& out, std::ostream& err);
ExitCode study_case(const StudyRequest& request, std::ostream& out, std::ostream& err);
ExitCode compare_case(const CompareRequest& request, std::ostream& out, std::ostream& err);
ExitCode adjoint_case(const AdjointRequest& request, std::ostream& out, std::ostream& err);
ExitCode check_case(const CheckRequest& request, std::ostream& out, std::ostream& err);
ExitCode mesh_case(const MeshRequest& request, std::ostream& out, std::ostream& err);
ExitCode show_directions(const DirectionsRequest& request, std::ostream& out);
ExitCode new_case(const NewRequest& request, std::ostream& out);

}  // namespace etendue
