// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include "app/command/begun_run.h"
#include "app/command/memory.h"
#include "app/command/probes.h"
#include "app/command/radiosity_text.h"
#include "app/command/run_radiosity.h"
#include "app/command/run_report.h"

namespace etendue {

ExitCode run_by_radiosity(const BegunRun& run, std::ostream& out, std::ostream& err,
                          const ResultReader& reader) {
  check_for_radiosity(run.input, run.problem);
  const CellLocator locator(run.problem.mesh());
  place_probes(run.input.probes, run.problem.mesh(), locator);
  const int threads = thread_count(run.input);
  const RadiosityMemory memory =
      estimate_radiosity_memory(run.problem, radiosity_options(run.input, threads));
  out << fmt::format("radiosity; bands: {}; threads: {}\n", run.problem.band_count(), threads)
      << radiosity_memory_text(memory)
      << check_memory(memory.bytes, run.problem.mesh(), run.problem.band_count()) << std::flush;
  if (!run.input.sensors.empty())
    out << "  radiosity reads no sensors in this version: those of the case do nothing here\n";
  if (!run.input.cameras.empty())
    out << "  radiosity takes no pictures in this version: the cameras of the case do nothing here\n";
  run.interruption.note_the_first();
  RadiosityRun found =
      run_radiosity(run.input, run.problem, locator, threads, out, [&] { return run.interruption.noted(); });
  run.interruption.note_all();
  RunResult result = result_of(run, found.solution, std::move(found.probes), threads);
  result.radiosity = std::move(found.report);
  result.passes = std::move(found.passes);
  const WrittenResults written = write_results(result);
  out << radiosity_text(result) << balance_text(result) << powers_text(result) << probes_text(result)
      << closing_text(result, written);
  if (reader) reader(result);
  return conclude(result, run.interruption.noted(), err);
}

}  // namespace etendue
