// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/solve_radiosity.h"

#include <algorithm>
#include <chrono>
#include <numbers>

#include "mesh/tetrahedra/sheet_faces.h"
#include "solver/radiosity/sheet_passages.h"
#include "solver/radiosity/wall_factors.h"

namespace etendue {
namespace {

bool has_redirecting_walls(const Problem& problem) {
  return std::ranges::any_of(
      problem.walls(), [](const Wall& wall) { return redirects(wall, Redirection::mirrors_and_lobes); });
}

constexpr double pi = std::numbers::pi;
// Error of row sums after closing: far below that of the factors.
constexpr double closed = 1e-12;
// What may be on its way where a solution is looked at for refinement: of links, and of the change that
// patches are cut for.
constexpr double rough = 0.01;

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Four points of degree 2 in a tetrahedron (Keast 1986, rule 2): weights 1/4, this near to a vertex each.
constexpr double near_share = 0.585410196624968515, far_share = 0.138196601125010504;

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
                 static_cast<std::size_t>(mesh.cell_count()) * 16 * bands * sizeof(double);
  if (options.method == RadiosityMethod::direct) memory.bytes += 2 * matrix;
  if (has_redirecting_walls(problem))
    memory.bytes += ExtendedExchange::bytes_of(patches, options.path_rays, bands);
  return memory;
}

RadiosityRoom::RadiosityRoom(const Problem& problem, const RadiosityOptions& options,
                             const RadiosityWatcher& watcher)
    : problem_(problem), options_(options), bands_(static_cast<std::size_t>(problem.band_count())) {
  refuse_for_radiosity(problem);
  const Clock::time_point start = Clock::now();
  patches_ = wall_patches(problem.mesh(), options.patch_size);
  for (;;) {
    make_factors(watcher);
    if (options.refinement.change <= 0) break;
    const RadiosityLimits roughly = {std::max(options.limits.tolerance, rough * options.refinement.change),
                                     options.limits.most_passes};
    const std::vector<bool> cut = patches_to_cut(
        problem.mesh(), patches_, solve_by_gathering(equation(), roughly).irradiance, options.refinement);
    if (std::ranges::count(cut, true) == 0) break;
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
  extended_.reset();
  exchange_.reset();
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

Solution RadiosityRoom::solve(const RadiosityObserver& observer) {
  Clock::time_point start = Clock::now();
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
  start = Clock::now();
  fill_cells(solution);
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

void RadiosityRoom::fields_on_walls(const RadiosityState& state, Solution& fields) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto faces = static_cast<std::size_t>(mesh.boundary_face_count());
  fields.irradiance.assign(faces * 3 * bands_, 0);
  fields.exitance.assign(faces * 3 * bands_, 0);
  fields.half_range.assign(faces, pi);
  const std::vector<std::int32_t> behind = faces_behind(mesh);
  const auto mean_on = [&](const std::vector<double>& values, std::size_t face, std::size_t band) {
    double mean = 0;
    for (const FacePart& part : patches_.of_faces[face])
      mean += part.share * values[part.patch * bands_ + band];
    return mean;
  };
  for (std::size_t f = 0; f < faces; ++f) {
    const Wall& wall = problem_.wall(mesh.wall(FaceIndex(static_cast<std::int64_t>(f))));
    for (std::size_t b = 0; b < bands_; ++b) {
      const double mean = mean_on(state.irradiance, f, b);
      double sent = pi * wall.radiance[b] + wall.diffuse[b] * mean;
      if (wall.transmitted(b) > 0)
        sent += wall.transmitted(b) * mean_on(state.irradiance, static_cast<std::size_t>(behind[f]), b);
      if (!state.redirected.empty()) sent += mean_on(state.redirected, f, b);
      for (std::size_t node = 3 * f; node < 3 * f + 3; ++node) {
        fields.irradiance[node * bands_ + b] = mean;
        fields.exitance[node * bands_ + b] = sent;
      }
    }
  }
}

WallLightField RadiosityRoom::light(int rays, int path_rays) const {
  WallLightField field(*exchange_, exitance_, bands_, rays);
  if (extended_ != nullptr) field.look_along(extended_->paths(), path_rays);
  return field;
}

// What comes from these walls as lights are followed along rays: straight, and by way of mirrors, but not of
// glossy walls. H_j = sum over k of G_jk E_k / A_j.
std::vector<double> RadiosityRoom::straight_irradiance(const std::vector<bool>& walls) const {
  std::vector<double> emission = equation().emission;
  for (std::size_t i = 0; i < emission.size(); ++i)
    if (!walls[static_cast<std::size_t>(patches_.walls[i / bands_])]) emission[i] = 0;
  std::vector<double> irradiance;
  if (extended_ == nullptr) {
    irradiance = exchange_->times(emission, bands_);
  } else {
    ExtendedExchange mirrored(*exchange_, problem_, patches_, Redirection::mirrors_alone, options_.path_rays);
    mirrored.close_as(*extended_);
    irradiance = mirrored.times(emission);
  }
  for (std::size_t i = 0; i < irradiance.size(); ++i)
    irradiance[i] /= exchange_->patches()[i / bands_].area();
  return irradiance;
}

SavedState RadiosityRoom::state(const std::vector<bool>& followed, std::span<const double> half_range) const {
  std::vector<double> rest = solved_.irradiance;
  if (std::ranges::count(followed, true) > 0) {
    const std::vector<double> straight = straight_irradiance(followed);
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= straight[i];
  }
  SavedState state;
  state.bands = static_cast<int>(bands_);
  state.fluence.assign(static_cast<std::size_t>(problem_.mesh().cell_count()) * 4 * bands_, 0);
  state.irradiance = means_at_vertices(problem_.mesh(), patches_, rest, bands_);
  for (std::size_t i = 0; i < state.irradiance.size(); ++i)
    state.irradiance[i] *= half_range[i / (3 * bands_)] / pi;
  return state;
}

// The P1 field that takes the values at the four points of the rule: the projection on P1 by that rule.
void RadiosityRoom::fill_cells(Solution& fields) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto cells = static_cast<std::size_t>(mesh.cell_count());
  fields.fluence.assign(cells * 4 * bands_, 0);
  fields.net_flux.assign(cells * 12 * bands_, 0);
  const WallLightField field = light(1, options_.path_rays);
#pragma omp parallel for schedule(dynamic, 64) num_threads(options_.threads)
  for (std::size_t c = 0; c < cells; ++c) {
    const auto& vertices = mesh.vertices(CellIndex(static_cast<std::int64_t>(c)));
    double* fluence = fields.fluence.data() + c * 4 * bands_;
    double* net_flux = fields.net_flux.data() + c * 12 * bands_;
    for (std::size_t i = 0; i < 4; ++i) {
      Vec3 point = Vec3::Zero();
      for (std::size_t k = 0; k < 4; ++k)
        point += (k == i ? near_share : far_share) * mesh.point(VertexIndex(vertices[k]));
      field.add_at(point, {fluence + i * bands_, bands_}, {net_flux + i * 3 * bands_, 3 * bands_});
    }
    const auto to_vertices = [](double* values, std::size_t count) {
      for (std::size_t v = 0; v < count; ++v) {
        const double sum = values[v] + values[count + v] + values[2 * count + v] + values[3 * count + v];
        for (std::size_t i = 0; i < 4; ++i)
          values[i * count + v] = (values[i * count + v] - far_share * sum) / (near_share - far_share);
      }
    };
    to_vertices(fluence, bands_);
    to_vertices(net_flux, 3 * bands_);
  }
}

}  // namespace etendue
