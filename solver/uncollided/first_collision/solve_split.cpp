// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/solve_split.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/field_view.h"
#include "base/parallel/parallel_for.h"
#include "base/parallel/thread_count.h"
#include "base/vector_sums.h"
#include "base/wall_clock.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/problem/lights/beam_pieces.h"
#include "solver/solution/following_emission.h"
#include "solver/solution/node_means.h"
#include "solver/transport/solve/solve.h"
#include "solver/uncollided/first_collision/first_collided_solution.h"
#include "solver/uncollided/first_collision/first_collision.h"
#include "solver/uncollided/sources/beam_source.h"
#include "solver/uncollided/sources/sky_source.h"

namespace etendue {
namespace {

/// What lights on walls send in, and mirrors send on, added to the exitance; the powers of the lights.
void add_exitance(const LightSetup& lights, const UncollidedField& field, Solution& solution) {
  const Problem& problem = lights.problem();
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const FaceField exitance(solution.exitance, bands);
  const ConstFaceField irradiance(field.irradiance, bands);
  // What is swept is in them already.
  solution.lights.from_walls.resize(problem.walls().size(), std::vector<double>(bands, 0));
  solution.lights.inside.resize(bands, 0);
  std::vector<const BeamLight*> beams;
  for (const auto& source : lights.sources()) {
    if (const auto* beam = dynamic_cast<const BeamSource*>(source.get())) beams.push_back(&beam->light());
    if (const auto* sky = dynamic_cast<const SkySource*>(source.get()))
      for (const BeamLight& part : sky->parts()) beams.push_back(&part);
  }
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const int w = mesh.wall(face);
    const Wall& wall = problem.wall(w);
    std::vector<double> sent(bands, 0);
    for (std::size_t b = 0; b < bands && lights.has_wall(w); ++b)
      sent[b] = std::numbers::pi * wall.radiance[b];
    for (const BeamLight* beam : beams)
      if (std::count(beam->walls.begin(), beam->walls.end(), w) > 0) {
        const double seen = entering_area(*beam, mesh, face) / mesh.area(face);
        for (std::size_t b = 0; b < bands; ++b) sent[b] += seen * beam->irradiance[b];
      }
    for (std::size_t b = 0; b < bands; ++b) {
      solution.lights.from_walls[static_cast<std::size_t>(w)][b] += sent[b] * mesh.area(face);
      for (std::size_t i = 0; i < 3; ++i)
        exitance(face, i, b) += sent[b] + wall.specular[b] * irradiance(face, i, b);
    }
  }
}

/// [cell][band] absorption times the mean fluence [power/length^3].
std::vector<double> absorbed_power(const Problem& problem, const std::vector<double>& fluence) {
  std::vector<double> absorbed = node_means(fluence, 4, static_cast<std::size_t>(problem.band_count()));
  for (std::size_t i = 0; i < absorbed.size(); ++i) absorbed[i] *= problem.absorption()[i];
  return absorbed;
}

/// Adds what a cell absorbs and scatters.
void add_cell(const Problem& problem, const UncollidedField& field, CellIndex cell, std::size_t band,
              UncollidedBalance& balance) {
  const auto bands = static_cast<std::size_t>(problem.band_count());
  const double volume = problem.mesh().volume(cell);
  if (!field.absorbed.empty()) {
    balance.absorbed += volume * ConstBandTable(field.absorbed, bands)(cell, band);
    for (std::size_t i = 0; i < 4; ++i)
      balance.collided += volume * ConstCellField(field.collided, bands)(cell, i, band) / 4;
    return;
  }
  const double fluence = ConstCellField(field.fluence, bands).mean(cell, band) * volume;
  balance.absorbed += problem.absorption(cell, static_cast<int>(band)) * fluence;
  balance.collided += problem.scattering(cell, static_cast<int>(band)) * fluence;
}

/// Adds what a boundary face reflects and keeps.
void add_face(const Problem& problem, const UncollidedField& field, FaceIndex face, std::size_t band,
              UncollidedBalance& balance) {
  const TetrahedralMesh& mesh = problem.mesh();
  const Wall& wall = problem.wall(mesh.wall(face));
  const ConstFaceField irradiance(field.irradiance, static_cast<std::size_t>(problem.band_count()));
  const std::int32_t glossy = field.glossy.place_of(face);
  for (std::size_t i = 0; i < 3; ++i) {
    const double arrived = irradiance(face, i, band) / 3 * mesh.area(face);
    const double lobe =
        glossy < 0 ? 0 : field.glossy.albedo(problem, static_cast<std::size_t>(glossy), i, band);
    const double reflected = wall.diffuse[band] + wall.transmitted(band) + lobe;
    balance.reflected += reflected * arrived;
    balance.kept += (1 - wall.diffuse[band] - wall.transmitted(band) - lobe - wall.specular[band]) * arrived;
  }
}

/// Powers of the uncollided light.
std::vector<UncollidedBalance> balance_of(const LightSetup& lights, const UncollidedField& field) {
  const Problem& problem = lights.problem();
  const TetrahedralMesh& mesh = problem.mesh();
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<UncollidedBalance> balances(bands);
  for (std::size_t b = 0; b < bands; ++b) {
    UncollidedBalance& balance = balances[b];
    for (const auto& source : lights.sources()) balance.sent += source->power()[b];
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) add_cell(problem, field, CellIndex(c), b, balance);
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
      add_face(problem, field, FaceIndex(f), b, balance);
    const double found = balance.absorbed + balance.collided + balance.reflected + balance.kept;
    balance.residual = balance.sent > 0 ? (balance.sent - found) / balance.sent : 0;
  }
  return balances;
}

/// Lights that are neither walls nor media, nor beams or a sky that walls let in. They are the first of the
/// sources.
void add_lights_inside(const LightSetup& lights, Solution& solution) {
  std::size_t source = 0;
  for (const Light& light : lights.problem().lights()) {
    if (light.uncollided == Uncollided::no) continue;
    for (std::size_t b = 0;
         b < solution.lights.inside.size() && !std::holds_alternative<BeamLight>(light.kind); ++b)
      solution.lights.inside[b] += lights.sources()[source]->power()[b];
    ++source;
  }
}

void add_meters(const LightSetup& lights, const SolveOptions& options, int threads, Solution& solution) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const std::size_t bands = lights.paths().bands();
  parallel_for(options.meters.size(), threads, 1, [&](std::size_t i) {
    const CellPoint& place = options.meters[i].cells.front();
    Vec3 position = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) position += place.barycentric[k] * corner_of(mesh, place.cell, k);
    const LightAtPoint light = lights.at({place.cell, position}, options.meters[i].normal);
    for (std::size_t b = 0; b < bands; ++b) solution.meters[i * bands + b] += light.irradiance[b];
    return true;
  });
}

}  // namespace

UncollidedLight::UncollidedLight(const LightSetup& lights, const SolveOptions& options,
                                 const StageObserver& observer)
    : lights_(lights), threads_(thread_count(options.threads)) {
  if (lights.empty()) return;
  const auto start = WallClock::now();
  field_ = uncollided_field(lights.paths(), lights.sources(), threads_, observer, options.ranks);
  seconds_ = seconds_since(start);
}

// The first collisions are a source of the one sweep or of the other.
Solution UncollidedLight::sweep_rest(const DirectionSet& directions, const DirectionSet* first_collided,
                                     const SolveOptions& options, const SolveObserver& observer,
                                     const DirectionSetObserver& reader) const {
  const Problem remaining = lights_.remaining();
  SolveOptions with_input = options;
  if (options.following_emission != nullptr)
    options.following_emission->set_unswept({field_.fluence, field_.irradiance, {}});
  if (first_collided != nullptr) {
    const FirstCollidedSolution first(lights_, field_, remaining, *first_collided, directions, options,
                                      threads_);
    with_input.angular_input = &first;
    Solution solution = solve(remaining, directions, with_input, observer);
    if (reader) {
      const DirectionSetSolution finer = first.swept();
      reader({directions, solution, &first, &finer});
    }
    first.add_to(solution);
    return solution;
  }
  const auto start = WallClock::now();
  const FirstCollision input(lights_, field_, directions, threads_);
  const double seconds = seconds_since(start);
  with_input.angular_input = &input;
  Solution solution = solve(remaining, directions, with_input, observer);
  solution.seconds.lights = seconds;
  if (reader) reader({directions, solution, &input});
  return solution;
}

Solution UncollidedLight::solve_rest(const DirectionSet& directions, const DirectionSet* first_collided,
                                     const SolveOptions& options, const SolveObserver& observer,
                                     const DirectionSetObserver& reader) const {
  if (lights_.empty()) {
    Solution whole = solve(lights_.problem(), directions, options, observer);
    whole.notes.insert(whole.notes.begin(), lights_.notes().begin(), lights_.notes().end());
    if (reader) reader({directions, whole, options.angular_input});
    return whole;
  }
  Solution solution = sweep_rest(directions, first_collided, options, observer, reader);
  complete(solution, options);
  return solution;
}

void UncollidedLight::complete(Solution& solution, const SolveOptions& options) const {
  const auto start = WallClock::now();
  solution.notes.insert(solution.notes.begin(), lights_.notes().begin(), lights_.notes().end());
  solution.lights.balance = balance_of(lights_, field_);
  add_exitance(lights_, field_, solution);
  add_lights_inside(lights_, solution);
  for (std::size_t w = 0; w < lights_.problem().walls().size(); ++w)
    solution.lights.exact_walls.push_back(lights_.has_wall(static_cast<int>(w)));
  if (!field_.absorbed.empty()) {
    if (solution.absorbed.empty()) solution.absorbed = absorbed_power(lights_.problem(), solution.fluence);
    add_to(solution.absorbed, field_.absorbed);
  }
  add_to(solution.fluence, field_.fluence);
  add_to(solution.net_flux, field_.net_flux);
  add_to(solution.irradiance, field_.irradiance);
  add_meters(lights_, options, threads_, solution);
  solution.negative = negative_census(solution.fluence, lights_.paths().bands());
  solution.seconds.lights += seconds_since(start);
}

void UncollidedLight::finish(Solution& solution) {
  solution.seconds.lights += seconds_;
  solution.lights.fluence = field_.fluence;
  solution.lights.net_flux = std::move(field_.net_flux);
  first_collisions_ = std::make_shared<const FirstCollisions>(
      first_collisions_of(lights_.problem(), std::exchange(field_, {})));
}

Solution solve_split(const LightSetup& lights, const DirectionSet& directions, const SolveOptions& options,
                     const SolveObserver& observer, const DirectionSet* first_collided,
                     const DirectionSetObserver& reader) {
  UncollidedLight uncollided(lights, options);
  Solution solution = uncollided.solve_rest(directions, first_collided, options, observer, reader);
  uncollided.finish(solution);
  return solution;
}

std::size_t estimate_split_memory(const LightSetup& lights, const DirectionSet& directions,
                                  const SolveOptions& options, const DirectionSet* first_collided,
                                  KrylovVectors vectors) {
  const std::size_t rest = estimate_memory(lights.problem(), directions, options, vectors);
  if (lights.empty()) return rest;
  if (first_collided == nullptr) return rest + FirstCollision::memory(lights, directions);
  SolveOptions one_sweep = options;
  one_sweep.method = Method::source_iteration;
  one_sweep.acceleration = Acceleration::none;
  const std::size_t field = FirstCollision::memory(lights, *first_collided);
  return std::max(
             rest + FirstCollidedSolution::memory(lights.problem(), directions, *first_collided, options),
             estimate_memory(lights.problem(), *first_collided, one_sweep, vectors)) +
         field;
}

}  // namespace etendue
