// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <optional>

#include "app/case/build.h"
#include "app/command/begun_run.h"
#include "app/command/memory.h"
#include "app/command/pictures.h"
#include "app/command/probes.h"
#include "app/command/progress.h"
#include "app/command/radiosity_text.h"
#include "app/command/run_radiosity.h"
#include "app/command/run_report.h"
#include "app/command/sensors.h"
#include "app/write/sensor_files.h"

namespace etendue {

ExitCode run_by_radiosity(const BegunRun& run, std::ostream& out, std::ostream& err,
                          const ResultReader& reader) {
  check_for_radiosity(run.input, run.problem);
  const CellLocator locator(run.problem.mesh());
  place_probes(run.input.probes, run.problem.mesh(), locator);
  const LightSetup lights(run.problem);
  const DirectionSet directions = build_directions(run.input);
  check_sensors(run.input.sensors, locator, run.problem.mesh());
  const int threads = thread_count(run.input);
  const RadiosityMemory memory =
      estimate_radiosity_memory(run.problem, radiosity_options(run.input, threads));
  out << fmt::format("radiosity; bands: {}; threads: {}\n", run.problem.band_count(), threads)
      << radiosity_memory_text(memory)
      << check_memory(memory.bytes, run.problem.mesh(), run.problem.band_count()) << std::flush;
  run.interruption.note_the_first();
  RadiosityRun found = run_radiosity({run.input, lights, directions, locator, threads}, out,
                                     [&] { return run.interruption.noted(); });
  run.interruption.note_all();
  SolveOptions options = run.input.solve;
  options.threads = threads;
  std::optional<RayRadiance> scene;
  if (!run.input.sensors.empty() || !run.input.cameras.empty())
    scene.emplace(lights, directions, options, found.solution.state, threads);
  RunResult result = result_of(run, found.solution, std::move(found.probes), threads);
  result.sensors = read_sensors(run.input.sensors, {lights, OrdinateBook(run.input.sensors, lights, locator),
                                                    options, found.solution, scene, locator});
  result.radiosity = std::move(found.report);
  result.passes = std::move(found.passes);
  const WrittenResults written = write_results(result);
  out << radiosity_text(result) << balance_text(result) << powers_text(result) << probes_text(result)
      << sensors_text(result) << closing_text(result, written);
  if (!run.input.cameras.empty() && !run.interruption.noted()) {
    const ErrorScenes none(run.input.cameras, lights, directions, options, found.solution.state, {});
    write_pictures(run.input, run.input.cameras, *scene, none, threads, run.input.output.directory,
                   resolved_style(run.request.progress, out), out, [&] { return run.interruption.noted(); });
  }
  if (reader) reader(result);
  return conclude(result, run.interruption.noted(), err);
}

}  // namespace etendue
