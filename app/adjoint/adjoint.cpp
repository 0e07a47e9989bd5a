// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "app/adjoint/chosen_response.h"
#include "app/adjoint/gradient_tables.h"
#include "app/adjoint/share_tables.h"
#include "app/case/build/build.h"
#include "app/progress/interruption.h"
#include "app/progress/progress.h"
#include "app/progress/stage_progress.h"
#include "app/request/commands.h"
#include "app/request/verbose_log.h"
#include "app/run/memory_forecast.h"
#include "app/run/ordinates_setup.h"
#include "app/setup/deprecation_notes.h"
#include "app/setup/run_context.h"
#include "app/write/result/output_folder.h"
#include "app/write/vtk/vtk_importance.h"
#include "base/errors.h"
#include "solver/adjoint/uncollided_importance.h"
#include "solver/transport/solve/solve.h"
#include "solver/uncollided/first_collision/first_collision.h"

namespace etendue {
namespace {

void refuse_other_methods(const Case& input) {
  if (input.photons || input.radiosity)
    throw InputError(
        "command line: adjoint: importance is solved for on directions; use solve.method = \"auto\"");
  if (input.exact) throw InputError("command line: adjoint: not of an exact radiance");
}

/// "importance-probe-desk": letters, digits, dots and dashes of the name, and lines for all others.
std::string file_stem(const std::string& name) {
  std::string stem = "importance-" + name;
  for (char& c : stem)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = c == ':' ? '-' : '_';
  return stem;
}

void refuse_equal_files(const std::vector<ChosenResponse>& responses) {
  for (auto it = responses.begin(); it != responses.end(); ++it)
    for (auto other = responses.begin(); other != it; ++other)
      if (it->name == other->name)
        throw InputError(fmt::format("command line: adjoint: --of = {}: is asked for twice", it->name));
      else if (file_stem(it->name) == file_stem(other->name))
        throw InputError(
            fmt::format("command line: adjoint: --of = {}: has the files of {}; ask for one of them",
                        it->name, other->name));
}

std::vector<std::string> write_importances(const std::vector<SolvedResponse>& solved, const Case& input,
                                           const Problem& problem) {
  const std::filesystem::path& directory = input.output.directory;
  OutputFolder folder(directory);
  for (const SolvedResponse& one : solved) {
    const std::string stem = file_stem(one.response.name);
    const std::string cells = stem + ".vtu", walls = stem + "-walls.vtp";
    const ImportanceFields fields{input,
                                  problem,
                                  one.solution.importance,
                                  one.response.unit_by_power,
                                  one.gradient ? &*one.gradient : nullptr,
                                  one.response.unit_by_area};
    write_importance(fields, folder.add(cells), directory / cells);
    write_importance_of_walls(fields, folder.add(walls), directory / walls);
  }
  folder.add_text("importance.csv", importance_csv(solved, problem.bands()));
  std::vector<std::pair<std::string, std::vector<Derivative>>> derivatives;
  for (const SolvedResponse& one : solved)
    if (one.gradient) derivatives.emplace_back(one.response.name, one.derivatives);
  if (!derivatives.empty()) folder.add_text("gradient.csv", gradient_csv(derivatives, problem.bands()));
  std::vector<std::string> names = folder.names();
  folder.publish({});
  return names;
}

std::string convergence_line(const Solution& solution) {
  int sweeps = 0;
  double residual = 0;
  for (const BandConvergence& band : solution.convergence) {
    sweeps = std::max(sweeps, band.sweeps);
    residual = std::max(residual, band.residual);
  }
  return fmt::format("{} after {} sweeps: estimated relative error {:.2g}",
                     solution.converged() ? "converged" : "NOT CONVERGED", sweeps, residual);
}

/// Takes the rays of directions out of the field of importance, where it comes from something small.
void follow_uncollided(const Problem& problem, const OrdinatesSetup& setup, const Response& response,
                       const StageDisplay& stages, Solution& importance) {
  std::string left_out;
  {
    ShownStage stage(stages, "importance before its first collision");
    left_out = follow_uncollided_importance(problem, setup.directions.sets, response, setup.options,
                                            importance, stage.observer());
  }
  if (!left_out.empty())
    stages.out << "the field of importance is that of the directions alone (" << left_out << ")\n";
}

/// Shows how a solution continues.
SolveObserver shown_on(ProgressDisplay& display) {
  return [&display](const SweepProgress& progress) {
    display.show(progress);
    return SolveControl::proceed;
  };
}

/// Memory of the solutions, with what a run does not take: the light of every source along rays, and for
/// gradients the solution of the case with its sweep.
RunMemory adjoint_memory(const OrdinatesSetup& setup, bool gradient) {
  RunMemory memory = setup.memory();
  std::size_t more = gradient ? memory.expected + gradient_bytes : 0;
  if (const std::size_t sources = setup.lights.sources().size(); sources > 1)
    more += (sources - 1) * FirstCollision::memory(setup.lights, setup.set());
  memory.solving += more;
  memory.expected += more;
  return memory;
}

/// The solution of the case itself, by which derivatives are found.
class PrimalSolution {
 public:
  PrimalSolution(const Problem& problem, const OrdinatesSetup& setup, const StageDisplay& stages)
      : problem_(on_directions(problem)), directions_(setup.set()), options_(setup.options) {
    options_.meters.clear();
    options_.keep_ordinates.clear();
    if (!setup.lights.empty())
      stages.out << "for the gradient all light is left to the directions, as with uncollided = false\n";
    ProgressDisplay display(stages.style, stages.out);
    solution_ = solve(problem_, directions_, options_, shown_on(display));
    display.finish();
    stages.out << "the case itself: " << convergence_line(solution_) << std::endl;
  }

  /// All that emits, as one.
  std::unique_ptr<const EmitterSource> source() const {
    return std::make_unique<const EmitterSource>(Emitter{EmitterKind::light, "", problem_}, options_.threads,
                                                 StageObserver());
  }
  Gradient gradient(const Response& response, const Solution& importance) const {
    return gradient_of(problem_, directions_, response, options_, solution_, importance);
  }
  bool converged() const { return solution_.converged(); }

 private:
  Problem problem_;
  const DirectionSet& directions_;
  SolveOptions options_;
  Solution solution_;
};

}  // namespace

ExitCode adjoint_case(const AdjointRequest& request, std::ostream& out, std::ostream& err) {
  Interruption interruption;  // until the files are written a signal ends the program at once
  const Case input = case_of(request.run);
  refuse_other_methods(input);
  write_deprecations(input, err);
  check_output_directory(input.output.directory);
  const StageDisplay stages{resolved_style(request.run.progress, out), out, {}};
  const TetrahedralMesh mesh = mesh_visibly(input, verbose_log(request.run, err), stages);
  const Problem problem = build_problem(input, mesh);
  const OrdinatesSetup setup(input, problem);
  const std::vector<ChosenResponse> responses =
      choose_responses(request.responses, input, problem, setup.locator);
  refuse_equal_files(responses);
  // What has no adjoint is refused before anything takes time.
  for (const ChosenResponse& response : responses) check_adjoint(problem, response.response, setup.options);
  if (request.gradient) check_gradient(problem, setup.set());
  if (request.gradient && setup.directions.sets.size() > 1)
    throw InputError("command line: adjoint: --gradient: needs one set; use directions.rotations = 1");
  out << fmt::format("mesh: {} cells; {}; bands: {}; threads: {}\n", mesh.cell_count(),
                     directions_line({setup.directions.sets, {}}, input), problem.band_count(),
                     setup.options.threads)
      << memory_text(adjoint_memory(setup, request.gradient), problem);
  if (!setup.directions.first_collided.empty())
    out << "light that has collided once is swept on these directions too: a run, which gives it "
        << setup.directions.first_collided.front().count() << ", reads another sum\n";
  out << std::flush;
  auto emitters = [&] {
    ShownStage stage(stages, "light of each emitter before its first collision");
    return emitter_sources(problem, setup.options.threads, stage.observer());
  }();
  if (emitters.empty()) out << "nothing emits: all quantities are 0\n";
  std::optional<PrimalSolution> primal;
  if (request.gradient) {
    primal.emplace(problem, setup, stages);
    emitters.push_back(primal->source());
  }
  std::vector<SolvedResponse> solved;
  for (const ChosenResponse& response : responses) {
    ProgressDisplay display(stages.style, out);
    AdjointSolution solution = solve_adjoint(emitters, problem, setup.directions.sets, response.response,
                                             setup.options, shown_on(display));
    display.finish();
    out << convergence_line(solution.importance) << '\n';
    std::vector<double> on_set;  // the response on the directions, of which the gradient is
    if (primal) {
      on_set = solution.shares.back().swept;
      solution.shares.pop_back();
    }
    solved.push_back({response, std::move(solution)});
    out << share_text(solved.back(), problem.bands()) << std::flush;
    if (primal) {
      solved.back().gradient = primal->gradient(response.response, solved.back().solution.importance);
      solved.back().derivatives = derivatives_of(*solved.back().gradient, problem, on_set);
      out << difference_text(on_set, solved.back().solution.response(), problem.bands())
          << gradient_text(solved.back().derivatives, problem.bands()) << std::flush;
    }
    follow_uncollided(problem, setup, response.response, stages, solved.back().solution.importance);
  }
  interruption.note_all();
  out << fmt::format("written to {}: {}\n", input.output.directory.string(),
                     fmt::join(write_importances(solved, input, problem), " "));
  const auto converged = [](const SolvedResponse& one) { return one.solution.importance.converged(); };
  if (std::ranges::all_of(solved, converged) && (!primal || primal->converged())) return ExitCode::done;
  err << "not converged: raise solve.max_sweeps or solve.tolerance\n";
  return ExitCode::not_converged;
}

}  // namespace etendue
