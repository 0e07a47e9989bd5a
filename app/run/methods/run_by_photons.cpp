// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <functional>

#include "app/progress/progress.h"
#include "app/readings/probes.h"
#include "app/render/photon_pictures.h"
#include "app/run/methods/photon_memory.h"
#include "app/run/methods/run_photons.h"
#include "app/run/report/photon_text.h"
#include "app/run/report/run_report.h"
#include "app/run/report/unreached.h"
#include "app/setup/run_context.h"
#include "app/time/photon_times.h"
#include "app/write/result/temperature_fields.h"
#include "app/write/results.h"

namespace etendue {

ExitCode run_by_photons(const RunContext& run, std::ostream& out, std::ostream& err,
                        const ResultReader& reader) {
  check_for_photons(run.input, run.problem);
  check_photon_cameras(run.input.cameras, run.problem);
  const CellLocator locator(run.problem.mesh());
  place_probes(run.input.probes, run.problem.mesh(), locator);
  const int threads = thread_count(run.input);
  out << fmt::format("photons; bands: {}; threads: {}{}\n", run.problem.band_count(), threads,
                     ranks_text(run.request.ranks))
      << memory_text(photon_run_memory(run.input, run.problem), run.problem) << std::flush;
  if (!run.input.sensors.empty())
    out << "  photons read no sensors in this version: those of the case do nothing here"
        << (run.input.time ? ", but that times have their fluence\n" : "\n");
  if (run.input.time) out << "  of light in time they read no irradiance\n";
  const ProgressStyle style = resolved_style(run.request.progress, out);
  const std::function<bool()> interrupted = [&] { return run.interruption.noted(); };
  const StageDisplay stages{style, out, interrupted};
  RunSeconds seconds = run.seconds;
  seconds.setup += run.watch.lap();
  PhotonRun found =
      run_photons({run.input, run.problem, locator, threads, stages, run.interruption, run.request.ranks});
  seconds.probes = found.probe_seconds;
  seconds.measures = run.watch.lap() - found.solution.seconds.sweep - found.probe_seconds;
  run.interruption.note_all();
  RunResult result = result_of(run, found.solution, std::move(found.probes), threads);
  set_probe_temperatures(locator, result);
  result.errors = std::move(found.errors);
  bound_unreached(result, locator, found.walked_back);
  if (run.input.time && !interrupted())
    result.time = photon_times(run.input, run.problem, locator, threads, stages);
  seconds.measures += run.watch.lap();
  seconds.total = run.watch.total();
  result.seconds = seconds;
  note_left_out(result);
  if (!writes_results(run.request.ranks))
    return conclude_beside(result, reader, run.interruption, run.request.ranks);
  const WrittenResults written = write_visibly(result, stages);
  out << photons_text(result) << balance_text(result) << powers_text(result) << probes_text(result)
      << time_text(result) << errors_text(result) << closing_text(result, written) << std::flush;
  if (!run.input.cameras.empty()) {
    const auto begun = std::chrono::steady_clock::now();
    const bool taken =
        !interrupted() && write_photon_pictures({run.input, run.input.cameras, run.input.output.directory,
                                                 style, out, interrupted, begun},
                                                run.problem, locator, threads);
    if (!taken) result.left_out.emplace_back("pictures");
  }
  if (reader) reader(result);
  return conclude(result, meet(run.request.ranks, run.interruption.noted()), err);
}

}  // namespace etendue
