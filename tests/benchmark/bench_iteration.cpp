// SPDX-License-Identifier: AGPL-3.0-or-later
//
// How many sweeps the iteration takes: GMRES with diffusion to 1e-8, the measured spectral radius of source
// iteration with diffusion, the share of time of the low-order solve, its set-up (once) in sweeps, and plain
// source iteration beside it. Unit cubes by TetGen, 96 directions, one thread. docs/measurements/iteration.md
// has the table. Then the diffusion limit: errors of a slab of five cells against the exact solution of
// diffusion.
//
//     bench_iteration [CELLS [FILTER [brief]]]
//
// CELLS: 600 (default), 5000 or 40000; FILTER: part of a name; brief: without radius and source iteration.
// Exit code 1 where a target is missed.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/diffusive_slab.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue {
namespace {

constexpr double tolerance = 1e-8;
constexpr int longest_source_iteration = 60;

enum class Scene { cube, ball, random_cells };

/// Extinction in the two regions, thicknesses being those of a cell of mean size in free paths.
struct Setting {
  std::string name;
  int target = 0;  ///< sweeps, all counted
  Scene scene = Scene::cube;
  double thickness = 0;  ///< of a cell of the cube
  double outside = 0;    ///< [1/length]
  double inside = 0;     ///< [1/length]
  double albedo = 1;
  double asymmetry = 0;
  int degree = -1;     ///< of moments; -1: as the phase function asks
  int mirrors = 0;     ///< the first of xmin, xmax, ymin, ymax, zmin that are mirrors
  double diffuse = 0;  ///< reflectance of all walls
  Lumping lumping = Lumping::none;
};

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const double thickness : {0.1, 1.0, 4.0, 10.0, 30.0, 100.0, 1000.0})
    all.push_back(
        {.name = fmt::format("homogeneous, {} paths", thickness), .target = 18, .thickness = thickness});
  for (const double thickness : {4.0, 10.0, 1000.0})
    all.push_back({.name = fmt::format("homogeneous, {} paths, lumped", thickness),
                   .target = 18,
                   .thickness = thickness,
                   .lumping = Lumping::mass});
  for (const double albedo : {0.99, 0.9})
    all.push_back({.name = fmt::format("albedo {}, 10 paths", albedo),
                   .target = 18,
                   .thickness = 10,
                   .albedo = albedo});
  all.push_back(
      {.name = "ball of 100 in 1e-8", .target = 22, .scene = Scene::ball, .outside = 1e-8, .inside = 100});
  all.push_back(
      {.name = "ball of 1e-8 in 100", .target = 22, .scene = Scene::ball, .outside = 100, .inside = 1e-8});
  all.push_back({.name = "random cells 100:1",
                 .target = 22,
                 .scene = Scene::random_cells,
                 .outside = 1,
                 .inside = 100});
  all.push_back({.name = "random cells 1000:0.1",
                 .target = 28,
                 .scene = Scene::random_cells,
                 .outside = 0.1,
                 .inside = 1000});
  all.push_back(
      {.name = "void ball in 200", .target = 28, .scene = Scene::ball, .outside = 200, .inside = 0});
  const std::pair<double, int> forward[] = {{0.5, 25}, {0.8, 36}, {0.9, 40}};
  for (const auto& [asymmetry, target] : forward)
    for (const int degree : {-1, 7})
      for (const double thickness : {1.0, 10.0, 100.0})
        all.push_back({.name = fmt::format("g = {}, {} paths{}", asymmetry, thickness,
                                           degree < 0 ? "" : fmt::format(", moments of degree {}", degree)),
                       .target = degree < 0 ? target : std::max(target, 45),
                       .thickness = thickness,
                       .asymmetry = asymmetry,
                       .degree = degree});
  for (const double thickness : {0.1, 1.0, 10.0}) {
    all.push_back({.name = fmt::format("five mirrors, {} paths", thickness),
                   .target = 25,
                   .thickness = thickness,
                   .mirrors = 5});
    all.push_back({.name = fmt::format("two mirrors, {} paths", thickness),
                   .target = 25,
                   .thickness = thickness,
                   .mirrors = 2});
  }
  all.push_back({.name = "diffuse 0.95 around vacuum", .target = 25, .diffuse = 0.95});
  return all;
}

TetrahedralMesh make_mesh(Scene scene, int cells) {
  Geometry geometry;
  BoxPrimitive box;
  box.region = "outside";
  geometry.primitives.emplace_back(box);
  if (scene == Scene::ball) {
    SpherePrimitive ball;
    ball.region = "inside";
    ball.center = Vec3(0.5, 0.5, 0.5);
    ball.radius = 0.3;
    ball.facets = 80;
    geometry.primitives.emplace_back(ball);
  }
  const SurfaceComplex surface = arrange(geometry);
  TetrahedraOptions options;
  // TetGen makes cells of about two fifths of the largest volume that is allowed.
  options.max_volume.assign(surface.region_names.size(), 2.1 / cells);
  RawMesh raw = tetrahedralize(surface, options);
  if (scene == Scene::random_cells) {
    std::mt19937 random(1);
    for (auto& region : raw.cell_regions) region = static_cast<int>(random() % 2);
    raw.region_names = {"outside", "inside"};
  }
  return TetrahedralMesh(raw);
}

Problem make_problem(const Setting& setting, const TetrahedralMesh& mesh) {
  const double cell_size = std::cbrt(6 * std::sqrt(2.0) / mesh.cell_count());
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    double extinction = name == "inside" ? setting.inside : setting.outside;
    if (setting.scene == Scene::cube) extinction = setting.thickness / cell_size;
    Medium medium{name, {(1 - setting.albedo) * extinction}, {setting.albedo * extinction}, {1.0}, {}, {}};
    if (setting.diffuse > 0) medium.emission[0] = 0;
    medium.phase.emplace_back();
    if (setting.asymmetry != 0) medium.phase[0] = PhaseHenyeyGreenstein{setting.asymmetry};
    if (setting.degree >= 0) medium.choice = {{ScatteringBackend::moments, setting.degree}};
    media.push_back(std::move(medium));
  }
  const std::vector<std::string> order = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    const auto place = std::find(order.begin(), order.end(), name) - order.begin();
    walls.push_back({name, {0.0}, {setting.diffuse}, {place < setting.mirrors ? 1.0 : 0.0}, {}});
    if (setting.diffuse > 0 && name == "xmin") walls.back().radiance[0] = 1;
  }
  return Problem(mesh, Bands{}, media, walls);
}

struct Run {
  const Problem& problem;
  const DirectionSet& directions;
  Lumping lumping;

  Solution solved(Method method, Acceleration acceleration, double to, int max_sweeps) const {
    SolveOptions options;
    options.lumping = lumping;
    options.method = method;
    options.acceleration = acceleration;
    options.tolerance = to;
    options.max_sweeps = max_sweeps;
    options.threads = 1;
    return solve(problem, directions, options);
  }
};

/// Mean factor by which the error fell over the last sweeps above 1e-7: below, only rounding may remain
/// of thick media.
double last_rate(const std::vector<HistoryEntry>& history) {
  constexpr std::size_t window = 5;
  std::size_t end = history.size();
  while (end > window + 1 && history[end - 1].residual < 1e-7) --end;
  if (end < window + 2) return history.size() < 2 ? 0 : history[1].residual / history[0].residual;
  return std::pow(history[end - 1].residual / history[end - 1 - window].residual, 1.0 / window);
}

/// A rate that was seen over so many sweeps says nothing of more than this many times as many: the slowest
/// part of the error does not show yet.
constexpr double longest_extrapolation = 100;

/// Sweeps of plain source iteration, extrapolated where they are too many to do, and a bound from below where
/// that means nothing: the rate only rises from sweep to sweep.
std::string source_iteration_sweeps(const Run& run) {
  const Solution plain =
      run.solved(Method::source_iteration, Acceleration::none, tolerance, longest_source_iteration);
  if (plain.converged()) return std::to_string(plain.convergence[0].sweeps);
  const double rate = last_rate(plain.history);
  if (rate >= 1) return fmt::format("> {}", longest_source_iteration);
  const double more = std::log(tolerance / plain.history.back().residual) / std::log(rate);
  const double longest = longest_extrapolation * longest_source_iteration;
  if (longest_source_iteration + more > longest) return fmt::format("> {:.0f}", longest);
  return fmt::format("~{:.2g}", longest_source_iteration + more);
}

/// Whether the target is met.
bool measure(const Setting& setting, int cells, const DirectionSet& directions, bool brief) {
  const TetrahedralMesh mesh = make_mesh(setting.scene, cells);
  const Problem problem = make_problem(setting, mesh);
  const Run run{problem, directions, setting.lumping};
  const Solution solution = run.solved(Method::gmres, Acceleration::diffusion, tolerance, 200);
  const int sweeps = solution.convergence[0].sweeps;
  const SolveSeconds& seconds = solution.seconds;
  const double solving = seconds.low_order - seconds.low_order_setup;
  const auto radius = [&] {
    return last_rate(run.solved(Method::source_iteration, Acceleration::diffusion, 1e-12, 50).history);
  };
  fmt::print("| {} | {} | {} | {} | {} | {} | {:.0f} % | {:.1f} | {} |\n", setting.name, mesh.cell_count(),
             fmt::format("{}{}", sweeps, solution.converged() ? "" : " not converged"), setting.target,
             sweeps <= setting.target ? "yes" : "no", brief ? "" : fmt::format("{:.2f}", radius()),
             100 * solving / (solving + seconds.sweep), seconds.low_order_setup / (seconds.sweep / sweeps),
             brief ? "" : source_iteration_sweeps(run));
  std::fflush(stdout);
  return solution.converged() && sweeps <= setting.target;
}

void measure_diffusion_limit(const DirectionSet& directions) {
  const TetrahedralMesh mesh = cube_mesh(3e-3);
  fmt::print("\n| diffusion limit: epsilon | cells | sweeps | tolerance | error |\n|---|---|---|---|---|\n");
  for (const double epsilon : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const Problem problem = diffusive_slab(mesh, epsilon);
    const Run run{problem, directions, Lumping::automatic};
    const double to = diffusive_slab_tolerance(epsilon);
    const Solution solution = run.solved(Method::gmres, Acceleration::diffusion, to, 200);
    fmt::print("| {:.0e} | {} | {}{} | {:.0e} | {:.3f} |\n", epsilon, mesh.cell_count(),
               solution.convergence[0].sweeps, solution.converged() ? "" : " not converged", to,
               fluence_error(mesh, solution, 1, diffusive_slab_fluence));
  }
}

}  // namespace
}  // namespace etendue

int main(int count, char** arguments) {
  using namespace etendue;
  const int cells = count > 1 ? std::atoi(arguments[1]) : 600;
  const std::string filter = count > 2 ? arguments[2] : "";
  const bool brief = count > 3 && std::string(arguments[3]) == "brief";
  const DirectionSet directions = directions_ldfe_sq(1);
  fmt::print(
      "| case | cells | sweeps | target | met | radius | low-order | set-up in sweeps | source iteration "
      "|\n");
  fmt::print("|---|---|---|---|---|---|---|---|---|\n");
  bool all_met = true;
  for (const Setting& setting : settings())
    if (setting.name.find(filter) != std::string::npos)
      all_met = measure(setting, cells, directions, brief) && all_met;
  if (std::string("diffusion limit").find(filter) != std::string::npos) measure_diffusion_limit(directions);
  return all_met ? 0 : 1;
}
