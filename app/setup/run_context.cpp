// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/setup/run_context.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <thread>

#include "app/case/build/build.h"
#include "app/write/result/balance_check.h"
#include "base/parallel/require_threads.h"

namespace etendue {
namespace {

/// What the results of an interrupted run are those of.
std::string last_state(const RunResult& result) {
  return result.errors ? fmt::format("{:.6g} histories in each band", result.errors->histories)
                       : "the last sweep";
}

}  // namespace

std::string how_to_go_on(const Case& input) {
  const std::filesystem::path file = std::filesystem::absolute(input.output.directory) / "solution.vtu";
  return fmt::format("to go on from there: --set 'solve.initial=\"{}\"'\n", file.string());
}

TetrahedralMesh mesh_visibly(const Case& input, const Log& log, const StageDisplay& stages) {
  const ShownStage stage(stages, input.mesh.file ? "reading the mesh" : "meshing");
  return build_mesh(input, log);
}

WrittenResults write_visibly(const RunResult& result, const StageDisplay& stages) {
  const ShownStage stage(stages, "writing");
  return write_results(result);
}

Case case_of(const RunRequest& request) {
  Case input = read_case(request.file, request.overrides);
  if (request.ranks != nullptr && input.solve.threads == 0) input.solve.threads = request.ranks->threads();
  if (request.traces == RunTraces::all) return input;
  if (request.traces == RunTraces::none) input.cameras.clear();
  input.initial.reset();
  input.output.checkpoint_every = 0;
  return input;
}

std::string ranks_text(const RankGroup* ranks) {
  return ranks == nullptr ? "" : fmt::format(" in each of {} processes", ranks->count());
}

std::optional<RunRanks> run_ranks(const RankGroup* ranks) {
  if (ranks == nullptr) return std::nullopt;
  return RunRanks{ranks->count(), ranks->traffic()};
}

int thread_count(const Case& input) {
  const int count = input.solve.threads > 0
                        ? input.solve.threads
                        : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  require_threads(count);
  return count;
}

namespace {

bool is_of_heat(const TimeResult& time) { return time.steps && time.steps->of == "temperature"; }

}  // namespace

void note_left_out(RunResult& result) {
  std::size_t points = 0;
  for (const Probe& probe : result.input.probes) points += probe.points.size();
  if (result.probes.size() < points)
    result.left_out.push_back(
        fmt::format("{} of {} points of probes", points - result.probes.size(), points));
  // Photons read no sensors.
  const std::size_t sensors = result.errors ? 0 : result.input.sensors.size();
  if (result.sensors.size() < sensors)
    result.left_out.push_back(fmt::format("{} of {} sensors", sensors - result.sensors.size(), sensors));
  const std::optional<TimeResult>& time = result.time;
  if (time && time->interrupted)
    result.left_out.push_back(is_of_heat(*time)
                                  ? fmt::format("temperatures after {:g} s", time->steps->steps.back().end)
                                  : "light in time");
  if (time && time->modulated.empty() && time->histories.empty() && time->flight_times.empty() &&
      (!time->steps || time->steps->steps.empty()))
    result.time.reset();
}

RunResult result_of(const RunContext& run, const Solution& solution, std::vector<ProbeRow> probes,
                    int threads) {
  RunResult result{.input = run.input,
                   .problem = run.problem,
                   .solution = solution,
                   .probes = std::move(probes),
                   .balances = balances(run.problem, solution),
                   .walls = wall_powers(run.problem, solution),
                   .regions = region_powers(run.problem, solution),
                   .seconds = run.seconds,
                   .threads = threads,
                   .ranks = run_ranks(run.request.ranks),
                   .record = run.request.record};
  result.seconds.total = run.watch.total();
  return result;
}

ExitCode conclude(const RunResult& result, bool interrupted, std::ostream& err) {
  if (interrupted) {
    const std::string missing =
        result.left_out.empty() ? "" : fmt::format(" but for {}", fmt::join(result.left_out, ", "));
    err << "interrupted: the results are whole" << missing << " and are those of "
        << (result.solution.converged() ? "the converged solution\n"
                                        : last_state(result) + "; " + how_to_go_on(result.input));
    return ExitCode::interrupted;
  }
  err << balance_warning(result);
  if (result.solution.converged()) {
    const bool in_time = !result.time || result.time->converged;
    if (!in_time && result.time->steps && !result.time->steps->fault.empty())
      err << "steps in time ended early: " << result.time->steps->fault << '\n';
    else if (!in_time)
      err << fmt::format(
          "{} in time is not converged: an estimated relative error of {:.2g} is left; raise "
          "solve.max_sweeps\n",
          is_of_heat(*result.time) ? "a temperature" : "light", result.time->residual);
    return is_balanced(result) && in_time ? ExitCode::done : ExitCode::not_converged;
  }
  if (result.errors)
    err << fmt::format(
        "the error is above solve.until = {} after solve.photons = {} histories in each band; the results "
        "are "
        "marked; {}",
        result.input.photons->until, result.input.photons->photons, how_to_go_on(result.input));
  else
    err << fmt::format(
        "not converged to solve.tolerance = {} within solve.max_sweeps = {}; the results are marked; {}",
        result.input.solve.tolerance, result.input.solve.max_sweeps, how_to_go_on(result.input));
  return ExitCode::not_converged;
}

ExitCode conclude_beside(const RunResult& result, const ResultReader& reader,
                         const Interruption& interruption, RankGroup* ranks) {
  if (reader) reader(result);
  std::ostream nowhere(nullptr);
  return conclude(result, meet(ranks, interruption.noted()), nowhere);
}

ExitCode conclude_without_traces(const RunResult& result, const ResultReader& reader) {
  if (reader) reader(result);
  const bool in_time = !result.time || result.time->converged;
  return result.solution.converged() && in_time ? ExitCode::done : ExitCode::not_converged;
}

}  // namespace etendue
