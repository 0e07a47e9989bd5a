// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>

#include "app/case/build/build.h"
#include "app/case/temperatures.h"
#include "app/progress/progress.h"
#include "app/progress/stage_progress.h"
#include "app/readings/probes.h"
#include "app/readings/sensors.h"
#include "app/render/pictures.h"
#include "app/request/verbose_log.h"
#include "app/run/memory_forecast.h"
#include "app/run/methods/visible_solution.h"
#include "app/run/methods/visible_steps.h"
#include "app/run/ordinates_setup.h"
#include "app/run/report/field_text.h"
#include "app/run/report/lamp_text.h"
#include "app/run/report/phase_text.h"
#include "app/run/report/resolution_text.h"
#include "app/run/report/run_log.h"
#include "app/run/report/run_report.h"
#include "app/setup/deprecation_notes.h"
#include "app/setup/fault_report.h"
#include "app/setup/output_memory.h"
#include "app/setup/run_context.h"
#include "app/time/heat_steps.h"
#include "app/time/solve_in_time.h"
#include "app/write/csv/sensor_files.h"
#include "app/write/result/output_folder.h"
#include "app/write/result/program_version.h"
#include "app/write/result/temperature_fields.h"
#include "app/write/results.h"
#include "app/write/vtk/solution_file.h"
#include "base/errors.h"
#include "solver/exact/exact_balance.h"
#include "solver/uncollided/first_collision/solve_rotated.h"

namespace etendue {
namespace {

/// Errors, and the powers that the exact radiance brings.
void add_exact(const ExactSetup& exact, const DirectionSet& directions, RunResult& result) {
  result.exact = compare_with_exact(result.problem, result.solution, exact.radiance, directions);
  add_exact_powers(exact.input, result.walls, result.regions, result.balances);
}

std::string mesh_line(const TetrahedralMesh& mesh) {
  return fmt::format("mesh: {} cells, {} vertices, {} faces on walls (regions: {}, walls: {})\n",
                     mesh.cell_count(), mesh.vertex_count(), mesh.boundary_face_count(),
                     mesh.region_names().size(), mesh.wall_names().size());
}

/// Whether something looks along rays.
bool need_rays(const Case& input, AngularSpace space) {
  return !input.cameras.empty() || std::ranges::any_of(input.sensors, [&](const SensorCase& sensor) {
    return !reads_ordinates(sensor, space);
  });
}

/// The seconds of a solution's stages; no time is in two of them.
double sum_of(const SolveSeconds& solve) {
  return solve.setup + solve.lights + solve.orders + solve.sweep + solve.low_order;
}

/// Where a run writes what people read.
struct RunStreams {
  std::ostream& progress;
  std::ostream& out;      ///< what is solved, and how
  std::ostream& results;  ///< what came of it
  std::ostream& err;
};

/// Runs the case of a request whose style of progress is resolved. Tells the log where it belongs when all
/// that the case names is read: a run that is refused before leaves no files.
ExitCode run_logged(const RunRequest& request, const RunStreams& streams, const ResultJudge& judge,
                    const ResultReader& reader, Interruption& interruption, RunLog& log) {
  auto& [shown, out, results, err] = streams;
  Stopwatch watch;
  RunSeconds seconds;
  const Case input = case_of(request);
  const bool writes = request.traces != RunTraces::none && writes_results(request.ranks);
  if (writes) check_output_directory(input.output.directory);
  check_output_memory(input);
  if (input.initial) check_initial(*input.initial, input);
  seconds.read = watch.lap();
  out << "etendue " << program_version() << ": "
      << (input.title.empty() ? request.file.string() : input.title) << std::endl;
  write_deprecations(input, out);

  const ProgressStyle style = request.progress;
  const std::function<bool()> interrupted = [&] { return interruption.noted(); };
  const StageDisplay stages{style, shown, interrupted};
  const TetrahedralMesh mesh = mesh_visibly(input, verbose_log(request, err), stages);
  seconds.mesh = watch.lap();
  if (writes && mesh.parents().mesh && !mesh.parents().mesh->patch_types.empty())
    check_output_directory(input.output.directory / "openfoam");
  out << mesh_line(mesh) << std::flush;
  std::optional<ShownStage> setting_up(std::in_place, stages, "setting up");
  Problem problem = build_problem(input, mesh);
  const std::vector<std::string> fields = field_texts(input, mesh);
  setting_up.reset();
  for (const std::string& field : fields) out << field << '\n';
  out << std::flush;
  seconds.setup = watch.lap();
  out << lamp_text(problem, input) << std::flush;
  if (writes && (input.photons || input.radiosity)) log.belongs_in(input.output.directory);
  if (input.photons)
    return run_by_photons({request, input, problem, seconds, watch, interruption, shown}, out, err, reader);
  if (input.radiosity)
    return run_by_radiosity({request, input, problem, seconds, watch, interruption, shown}, out, err, reader);
  setting_up.emplace(stages, "setting up");
  OrdinatesSetup setup(input, problem);
  const LightSetup& lights = setup.lights;
  const RunDirections& all_directions = setup.directions;
  const DirectionSet& directions = setup.set();
  const CellLocator& locator = setup.locator;
  SolveOptions& options = setup.options;
  options.ranks = request.ranks;
  OrdinateSensorTally ordinates(input.sensors, lights, locator);
  DirectionSetObserver tally_ordinates;
  if (need_all_ordinates(input.sensors, problem.space()))
    tally_ordinates = [&](const DirectionSetSolution& swept) {
      Stopwatch reading;
      setup.set_emission(problem);
      ordinates.add(options, swept);
      seconds.sensors += reading.lap();
    };
  setting_up.reset();
  SavedState initial;
  if (input.initial) {
    initial = read_initial(*input.initial, input, mesh);
    options.initial = &initial;
    out << "starts from " << input.initial->path.string() << std::endl;
  }
  const bool steps_heat = steps_temperatures(input);
  const bool asks_time = input.time && !steps_heat && request.traces == RunTraces::all;
  const RunMemory expected =
      asks_time || steps_heat ? directions_run_memory(input, problem, setup) : setup.memory();
  const std::string memory = memory_text(expected, problem);
  const Resolution resolution = setup.resolution(problem);
  out << fmt::format("{}; bands: {}; threads: {}{}\n", directions_line(all_directions, input),
                     problem.band_count(), options.threads, ranks_text(request.ranks))
      << refraction_caution(all_directions, problem)
      << resolution_text(resolution, !iterates_temperatures(input)) << memory << std::flush;
  for (const std::string& phase : phase_texts(input)) out << "scattering in " << phase << std::endl;
  for (const std::string& plan : plan_texts(problem, directions))
    out << "scattering in " << plan << std::endl;

  TimeSetup in_time{input, problem, all_directions.sets, options, locator, lights};
  if (steps_heat) out << heat_steps_text(input) << std::flush;
  if (asks_time) out << time_plan_text(in_time) << std::flush;

  if (writes) log.belongs_in(input.output.directory);
  seconds.setup += watch.lap();
  // A signal before the first sweep is done ends the program at once: there is nothing to keep.
  std::optional<UncollidedLight> uncollided;
  {
    ShownStage stage(stages, "light before its first collision");
    uncollided.emplace(lights, options, stage.observer());
  }
  if (asks_time) {
    auto kept = std::make_shared<UncollidedField>(uncollided->field());
    kept->net_flux = {};
    in_time.uncollided = std::move(kept);
  }
  const VisibleSolving solving{input,  problem, all_directions, options,
                               stages, err,     interruption,   writes && request.traces == RunTraces::all};
  std::optional<TimeResult> heat_in_time;
  const std::optional<Solution> solved =
      steps_heat ? step_visibly(*uncollided, solving,
                                {input, problem, *setup.temperatures, directions, options, locator},
                                tally_ordinates, heat_in_time.emplace())
                 : solve_visibly(*uncollided, solving, tally_ordinates);
  if (!solved) {
    meet(request.ranks, true);
    return ExitCode::interrupted;
  }
  const Solution& solution = *solved;
  setup.set_emission(problem);
  interruption.note_all();
  const bool is_interrupted = any_of(request.ranks, interruption.noted());
  // What is around the stages of the solution, and in none of them.
  seconds.setup += std::max(0.0, watch.lap() - sum_of(solution.seconds) - seconds.sensors);
  std::optional<RayRadiance> scene;
  if (need_rays(input, problem.space())) {
    const ShownStage stage(stages, "what rays look at");
    scene.emplace(lights, directions, options, solution.state, options.threads, WallValues::joined,
                  uncollided->first_collisions());
  }
  uncollided.reset();
  seconds.rays = watch.lap();
  RunResult result{.input = input,
                   .problem = problem,
                   .solution = solution,
                   .probes = {},
                   .balances = balances(problem, solution),
                   .walls = wall_powers(problem, solution),
                   .regions = region_powers(problem, solution),
                   .seconds = seconds,
                   .threads = options.threads,
                   .record = request.record,
                   .heat = setup.heat_solution(),
                   .expected_memory = static_cast<double>(expected.solving),
                   .is_coarse = is_coarse(resolution)};
  result.ranks = run_ranks(request.ranks);
  if (setup.exact) add_exact(*setup.exact, directions, result);
  result.seconds.measures = watch.lap();
  result.probes = read_probes(input.probes, lights, solution, locator, options.threads,
                              ShownStage(stages, "probes").observer());
  set_probe_temperatures(locator, result);
  result.seconds.probes = watch.lap();
  result.sensors = read_sensors(input.sensors, {lights, ordinates, options, solution, scene, locator},
                                ShownStage(stages, "sensors").observer());
  result.seconds.sensors += watch.lap();
  result.time = std::move(heat_in_time);
  if (asks_time && !is_interrupted) result.time = solve_in_time(in_time, solution, stages, interrupted);
  note_left_out(result);
  result.seconds.total = watch.total();
  const ResultUse use = request.traces == RunTraces::none ? ResultUse::none
                        : judge                           ? judge(result)
                                                          : ResultUse::all;
  if (use == ResultUse::none) return conclude_without_traces(result, reader);
  if (!writes) return conclude_beside(result, reader, interruption, request.ranks);
  const WrittenResults written = write_visibly(result, stages);
  (use == ResultUse::all ? results : out)
      << convergence_text(result) << uncollided_text(result) << balance_text(result) << powers_text(result)
      << probes_text(result) << sensors_text(result) << time_text(result) << exact_text(result)
      << cautions_text(result) << closing_text(result, written) << std::flush;
  if (use == ResultUse::files && !interruption.noted()) return conclude_without_traces(result, reader);
  if (!input.cameras.empty()) {
    const auto begun = std::chrono::steady_clock::now();
    bool taken = false;
    if (!interruption.noted()) {
      const ErrorImages errors(input.cameras, lights, directions, options, solution.state,
                               solution.direction_error, scene->first_collisions());
      taken = write_pictures(input, input.cameras, *scene, errors, options.threads, input.output.directory,
                             style, results, interrupted, begun);
    }
    if (!taken) result.left_out.emplace_back("pictures");
  }
  if (reader) reader(result);
  return conclude(result, meet(request.ranks, interruption.noted()), err);
}

/// With its style of progress, and the time it began.
RunRequest recorded_request(const RunRequest& request, const std::ostream& out) {
  RunRequest recorded = request;
  recorded.progress = resolved_style(request.progress, out);
  recorded.record.begun = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  return recorded;
}

/// Runs; of a run that fails the log is kept with the fault.
ExitCode with_log_of_faults(const RunLog& log, const std::function<ExitCode()>& run) {
  try {
    return run();
  } catch (const InputError&) {
    throw;  // a run that is refused leaves no files
  } catch (const std::exception& fault) {
    log.save_failed(report_of(fault).text);
    throw;
  }
}

}  // namespace

ExitCode run_case(const RunRequest& request, std::ostream& out, std::ostream& err,
                  const ResultReader& reader) {
  const RunRequest recorded = recorded_request(request, out);
  RunLog log(recorded.record);
  std::optional<Interruption> handling;
  if (request.traces == RunTraces::none) {
    std::ostream nowhere(nullptr);
    return run_logged(recorded, {out, nowhere, nowhere, err}, {}, reader,
                      handling.emplace(last_words_of_repetition), log);
  }
  Interruption& interruption = handling.emplace();
  return with_log_of_faults(log, [&] {
    const ExitCode code = [&] {
      LoggedStream logged_out(out, log), logged_err(err, log);
      return run_logged(recorded, {logged_out, logged_out, logged_out, logged_err}, {}, reader, interruption,
                        log);
    }();
    log.save();
    return code;
  });
}

ExitCode run_judged(const RunRequest& request, const ResultJudge& judge, std::ostream& out,
                    std::ostream& err) {
  const RunRequest recorded = recorded_request(request, out);
  RunLog log(recorded.record);
  Interruption interruption;
  ResultUse use = ResultUse::none;
  const ResultJudge noting = [&](const RunResult& result) { return use = judge(result); };
  return with_log_of_faults(log, [&] {
    const ExitCode code = [&] {
      std::ostream nowhere(nullptr);
      LoggedStream quiet(nowhere, log), logged_out(out, log), logged_err(err, log);
      return run_logged(recorded, {out, quiet, logged_out, logged_err}, noting, {}, interruption, log);
    }();
    if (use != ResultUse::none) log.save();
    return code;
  });
}

}  // namespace etendue
