// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/solve/solve_radiosity.h"

#include <algorithm>
#include <numbers>

#include "base/wall_clock.h"
#include "solver/radiosity/exchange/wall_factors.h"
#include "solver/radiosity/extended/extended_trace.h"
#include "solver/radiosity/solve/sheet_passages.h"

namespace etendue {
namespace {

bool has_redirecting_walls(const Problem& problem) {
  return std::ranges::any_of(
      problem.walls(), [](const Wall& wall) { return redirects(wall, Redirection::mirrors_and_lobes); });
}

using std::numbers::pi;
// Error of row sums after closing: far below that of the factors.
constexpr double closed = 1e-12;
// Residual power where a solution is examined for refinement: of links, and of the change that
// patches are cut for.
constexpr double rough = 0.01;

}  // namespace

RadiosityMemory radiosity_memory(const Problem& problem, const RadiosityOptions& options,
                                 std::size_t patches) {
  RadiosityMemory memory;
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  memory.patches = patches;
  const bool linked = options.method == RadiosityMethod::hierarchical;
  if (linked) memory.links = ExchangeLinks::likely_count(patches, options.link_tolerance);
  const std::size_t matrix =
      linked ? ExchangeLinks::bytes_of(memory.links) : ExchangeMatrix::bytes_of(patches);
  memory.kept = linked || matrix <= options.largest_kept;
  memory.bytes = (memory.kept ? matrix : 0) + memory.patches * (4096 + 8 * bands * sizeof(double)) +
                 static_cast<std::size_t>(mesh.cell_count()) * (1024 + 16 * bands * sizeof(double));
  if (options.method == RadiosityMethod::direct) memory.bytes += 2 * matrix;
  // Twice: pictures and sensors want what lights bring via mirrors.
  memory.bytes += 2 * bytes_of_traced_rays(problem, patches, options.path_rays);
  return memory;
}

RadiosityRoom::RadiosityRoom(const Problem& problem, const RadiosityOptions& options,
                             const RadiosityWatcher& watcher)
    : problem_(problem), options_(options), bands_(static_cast<std::size_t>(problem.band_count())) {
  refuse_for_radiosity(problem);
  const WallClock::time_point start = WallClock::now();
  patches_ = wall_patches(problem.mesh(), options.patch_size);
  for (;;) {
    make_factors(watcher);
    if (options.refinement.change <= 0) break;
    const RadiosityLimits roughly = {std::max(options.limits.tolerance, rough * options.refinement.change),
                                     options.limits.most_passes};
    const std::vector<bool> cut =
        patches_to_cut(problem.mesh(), patches_, straight_irradiance(roughly), options.refinement);
    if (std::ranges::count(cut, true) == 0) break;
    extended_.reset();
    exchange_.reset();
    patches_ = refined_patches(problem.mesh(), patches_, cut);
  }
  report_.wall_factors = factors_of_walls(*exchange_, patches_, problem.mesh().wall_names().size());
  report_.patches = exchange_->size();
  const auto [smallest, largest] = std::ranges::minmax(patches_.patches, {}, &FlatPatch::area);
  report_.smallest_area = smallest.area();
  report_.largest_area = largest.area();
  report_.convex = exchange_->visibility().is_convex();
  report_.factor_seconds = seconds_since(start);
}

// Irradiance via mirrors and glossy walls has the noise of the rays: patches would be cut for that,
// and the smaller they are the more.
std::vector<double> RadiosityRoom::straight_irradiance(const RadiosityLimits& limits) const {
  const RadiosityEquation now = equation();
  std::vector<double> irradiance = solve_by_gathering(now, limits).irradiance;
  if (extended_ == nullptr) return irradiance;
  std::vector<double> sent = now.sent_on(irradiance);
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] += now.emission[i];
  irradiance = exchange_->times(sent, bands_);
  for (std::size_t i = 0; i < irradiance.size(); ++i) irradiance[i] /= patches_.patches[i / bands_].area();
  return irradiance;
}

void RadiosityRoom::make_matrix(const FactorProgress& progress) {
  auto matrix = std::make_unique<ExchangeMatrix>(patches_.patches, options_.rays, options_.threads,
                                                 options_.largest_kept, progress);
  report_.kept = matrix->is_kept();
  exchange_ = std::move(matrix);
  extend();
  close();
}

void RadiosityRoom::extend() {
  if (!has_redirecting_walls(problem_)) return;
  extended_ = std::make_unique<ExtendedExchange>(*exchange_, problem_, patches_,
                                                 Redirection::mirrors_and_lobes, options_.path_rays);
  report_.extended_entries = extended_->entries();
}

// Straight factors first, whose checks are their own.
void RadiosityRoom::close() {
  report_.checks = check_and_close(*exchange_, closed);
  if (extended_ != nullptr) report_.extended_closing = extended_->close(closed);
}

// Links are found for what patches are likely to send, solved with, and split where they send more, until all
// stay for what they send.
void RadiosityRoom::make_links(const FactorProgress& progress) {
  const LinkRule rule{options_.link_tolerance, likely_brightness()};
  auto found =
      std::make_unique<ExchangeLinks>(patches_.patches, rule, options_.rays, options_.threads, progress);
  ExchangeLinks& links = *found;
  exchange_ = std::move(found);
  report_.link_rounds.clear();
  extend();
  do {
    close();
    report_.link_rounds.push_back(links.link_count());
  } while (links.refine(solved_brightness(), [&](double) { progress(1); }) > 0);
  report_.links = links.link_count();
}

std::vector<double> RadiosityRoom::solved_brightness() const {
  const RadiosityEquation now = equation();
  const std::vector<double> irradiance =
      solve_by_gathering(now, {rough, options_.limits.most_passes}).irradiance;
  const std::vector<double> sent_on = now.sent_on(irradiance);
  std::vector<double> brightness(patches_.patches.size(), 0);
  for (std::size_t b = 0; b < bands_; ++b) {
    double area = 0, power = 0;
    for (std::size_t p = 0; p < brightness.size(); ++p) {
      area += patches_.patches[p].area();
      power += patches_.patches[p].area() * irradiance[p * bands_ + b];
    }
    if (power <= 0) continue;
    for (std::size_t p = 0; p < brightness.size(); ++p) {
      const std::size_t i = p * bands_ + b;
      brightness[p] = std::max(brightness[p], (now.emission[i] + sent_on[i]) * area / power);
    }
  }
  return brightness;
}

// As if what is reflected came evenly to all walls: then H = sum of A E over sum of A (1 - rho).
std::vector<double> RadiosityRoom::likely_brightness() const {
  std::vector<double> brightness(patches_.patches.size(), 0);
  for (std::size_t b = 0; b < bands_; ++b) {
    double emitted = 0, absorbing = 0;
    for (std::size_t p = 0; p < brightness.size(); ++p) {
      const Wall& wall = problem_.wall(patches_.walls[p]);
      emitted += patches_.patches[p].area() * pi * wall.radiance[b];
      absorbing +=
          patches_.patches[p].area() *
          (1 - wall.diffuse[b] - redirected_part_of_isotropic(wall, b, Redirection::mirrors_and_lobes));
    }
    if (emitted <= 0 || absorbing <= 0) continue;
    for (std::size_t p = 0; p < brightness.size(); ++p) {
      const Wall& wall = problem_.wall(patches_.walls[p]);
      brightness[p] = std::max(brightness[p], pi * wall.radiance[b] * absorbing / emitted + wall.diffuse[b]);
    }
  }
  return brightness;
}

void RadiosityRoom::make_factors(const RadiosityWatcher& watcher) {
  RadiosityStage stage{report_.rounds.size(), patches_.patches.size(), 0};
  const auto tell = [&](double done) {
    stage.done = done;
    if (watcher) watcher(stage);
  };
  tell(0);
  const auto so_far = [&](double done) {
    if (done > 0) tell(done);  // 0 is told once
  };
  if (options_.method == RadiosityMethod::hierarchical)
    make_links(so_far);
  else
    make_matrix(so_far);
  report_.rounds.push_back(stage.patches);
}

RadiosityEquation RadiosityRoom::equation() const {
  RadiosityEquation equation{*exchange_, bands_, {}, {}};
  for (std::size_t p = 0; p < exchange_->size(); ++p) {
    const Wall& wall = problem_.wall(patches_.walls[p]);
    for (std::size_t b = 0; b < bands_; ++b) {
      equation.emission.push_back(pi * wall.radiance[b]);
      equation.reflectance.push_back(wall.diffuse[b]);
      equation.transmittance.push_back(wall.transmitted(b));
    }
  }
  if (std::ranges::any_of(problem_.walls(), [](const Wall& wall) { return wall.transmits(); }))
    equation.passages = sheet_passages(problem_.mesh(), patches_);
  equation.extended = extended_.get();
  return equation;
}

RadiosityState RadiosityRoom::solve(const RadiosityEquation& equation,
                                    const RadiosityObserver& observer) const {
  switch (options_.method) {
    case RadiosityMethod::direct:
      return solve_directly(equation);
    case RadiosityMethod::shooting:
      return solve_by_shooting(equation, options_.limits, observer);
    case RadiosityMethod::gathering:
    case RadiosityMethod::hierarchical:
      break;
  }
  return solve_by_gathering(equation, options_.limits, observer);
}

Solution RadiosityRoom::solve(const RadiosityObserver& observer, const FactorProgress& of_cells) {
  WallClock::time_point start = WallClock::now();
  const RadiosityEquation asked = equation();
  bool stopped = false;
  solved_ = solve(asked, [&](const RadiosityState& now) {
    stopped = observer && !observer(now);
    return !stopped;
  });
  const RadiosityState& state = solved_;
  report_.bounces = state.bounces;
  report_.passes = state.passes;
  report_.solve_seconds = seconds_since(start);
  exitance_ = asked.emission;
  const std::vector<double> sent_on = asked.sent_on(state.irradiance);
  for (std::size_t i = 0; i < exitance_.size(); ++i) exitance_[i] += sent_on[i];
  Solution solution;
  solution.method = "radiosity";
  fields_on_walls(state, solution);
  start = WallClock::now();
  fill_cells(solution, of_cells);
  report_.field_seconds = seconds_since(start);
  solution.seconds.sweep = report_.solve_seconds;
  solution.seconds.lights = report_.factor_seconds;
  solution.interrupted = stopped && !state.converged;
  for (const double residual : state.residual)
    solution.convergence.push_back({state.passes, residual, state.converged});
  for (const Bounce& bounce : state.bounces)
    solution.history.push_back(
        {bounce.pass, static_cast<int>(bounce.band),
         bounce.exitant > 0 ? (bounce.incident - bounce.redirected - bounce.deposit) / bounce.exitant : 0});
  solution.negative = negative_census(solution.fluence, bands_);
  return solution;
}

}  // namespace etendue
