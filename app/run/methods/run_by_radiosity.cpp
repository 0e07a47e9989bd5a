// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <optional>

#include "app/case/build/build.h"
#include "app/progress/factor_progress.h"
#include "app/progress/progress.h"
#include "app/readings/probes.h"
#include "app/readings/sensors.h"
#include "app/render/pictures.h"
#include "app/run/methods/run_radiosity.h"
#include "app/run/report/radiosity_text.h"
#include "app/run/report/run_report.h"
#include "app/setup/memory.h"
#include "app/setup/output_memory.h"
#include "app/setup/run_context.h"
#include "app/write/csv/sensor_files.h"
#include "app/write/result/temperature_fields.h"
#include "app/write/results.h"

namespace etendue {

ExitCode run_by_radiosity(const RunContext& run, std::ostream& out, std::ostream& err,
                          const ResultReader& reader) {
  check_for_radiosity(run.input, run.problem);
  const CellLocator locator(run.problem.mesh());
  place_probes(run.input.probes, run.problem.mesh(), locator);
  const LightSetup lights(run.problem);
  const DirectionSet directions = build_directions(run.input, run.problem);
  check_sensors(run.input.sensors, locator, run.problem);
  const int threads = thread_count(run.input);
  out << fmt::format("radiosity; bands: {}; threads: {}\n", run.problem.band_count(), threads);
  // Until there is light on the walls a signal ends the program at once.
  const RadiosityOptions asked = radiosity_options(run.input, threads);
  const Stopwatch watch;
  RunSeconds seconds = run.seconds;
  seconds.setup += run.watch.lap();
  const ProgressStyle style = resolved_style(run.request.progress, run.shown);
  const std::function<bool()> interrupted = [&] { return run.interruption.noted(); };
  const StageDisplay stages{style, run.shown, interrupted};
  FactorDisplay display(style, run.shown);
  RadiosityRoom room(run.problem, asked, [&](const RadiosityStage& stage) {
    display.show(stage, watch.total());
    if (stage.done > 0) return;
    const RadiosityMemory memory = radiosity_memory(run.problem, asked, stage.patches);
    const auto pictures =
        static_cast<std::size_t>(run.request.traces == RunTraces::none ? 0 : output_memory(run.input));
    const std::string total =
        check_memory(memory.bytes + pictures, run.problem.mesh(), run.problem.band_count());
    if (stage.round > 0) out << fmt::format("cut where the light changes, {}: ", stage.round);
    out << radiosity_memory_text(memory) << (stage.round > 0 ? "" : total) << std::flush;
  });
  display.finish();
  out << fmt::format("form factors in {:.3g} s\n", room.report().factor_seconds) << std::flush;
  FactorDisplay of_cells(style, run.shown, "light in the cells");
  std::optional<double> begun;
  RadiosityRun found;
  try {
    found = run_radiosity({run.input, lights, directions, locator, stages, run.interruption}, room,
                          [&](double done) {
                            if (!begun) of_cells.show({}, *(begun = watch.total()));
                            of_cells.show({.done = done}, watch.total());
                          });
  } catch (const RadiosityStopped&) {
    of_cells.finish();
    err << "interrupted: nothing was written\n";
    return ExitCode::interrupted;
  }
  of_cells.finish();
  run.interruption.note_all();
  SolveOptions options = run.input.solve;
  options.threads = threads;
  const RadiosityReport& report = found.report;
  seconds.probes = found.probe_seconds;
  seconds.measures = run.watch.lap() - found.probe_seconds - report.factor_seconds - report.solve_seconds -
                     report.field_seconds;
  std::optional<RayRadiance> scene;
  if (!run.input.sensors.empty() || !run.input.cameras.empty())
    scene.emplace(lights, directions, options, found.solution.state, threads);
  seconds.rays = run.watch.lap();
  RunResult result = result_of(run, found.solution, std::move(found.probes), threads);
  set_probe_temperatures(locator, result);
  result.radiosity = std::move(found.report);
  result.passes = std::move(found.passes);
  result.patches = std::move(found.patches);
  result.pass_patches = std::move(found.pass_patches);
  seconds.measures += run.watch.lap();
  result.sensors = read_sensors(run.input.sensors,
                                {lights, OrdinateSensorTally(run.input.sensors, lights, locator), options,
                                 found.solution, scene, locator},
                                ShownStage(stages, "sensors").observer());
  seconds.sensors = run.watch.lap();
  seconds.total = run.watch.total();
  result.seconds = seconds;
  note_left_out(result);
  if (run.request.traces == RunTraces::none) return conclude_without_traces(result, reader);
  const WrittenResults written = write_visibly(result, stages);
  out << radiosity_text(result) << balance_text(result) << powers_text(result) << probes_text(result)
      << sensors_text(result) << closing_text(result, written) << std::flush;
  if (!run.input.cameras.empty()) {
    const auto pictures_begun = std::chrono::steady_clock::now();
    bool taken = false;
    if (!interrupted()) {
      const ErrorImages none(run.input.cameras, lights, directions, options, found.solution.state, {});
      taken = write_pictures(run.input, run.input.cameras, *scene, none, threads, run.input.output.directory,
                             style, out, interrupted, pictures_begun);
    }
    if (!taken) result.left_out.emplace_back("pictures");
  }
  if (reader) reader(result);
  return conclude(result, run.interruption.noted(), err);
}

}  // namespace etendue
