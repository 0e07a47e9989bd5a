// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/adjoint/uncollided_importance.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/parallel/thread_count.h"
#include "base/vector_sums.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/adjoint/response_source.h"
#include "solver/adjoint/reversed_problem.h"
#include "solver/transport/solve/read_out.h"
#include "solver/transport/sweep/transport_sweep.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Part of the way to the centroid of its cell by which a point moves, so that it lies on no wall.
constexpr double step_inside = 1e-6;
/// Sweeps in which mirrors at right angles have passed all on.
constexpr int most_bounces = 8;
/// Steps of the table of a cosine: linear between them it is right to 4e-5.
constexpr int cosine_steps = 90;

Vec3 point_inside(const TetrahedralMesh& mesh, const std::vector<CellPoint>& cells) {
  const PointInCell point = point_of(mesh, cells);
  Vec3 centroid = Vec3::Zero();
  for (const Vec3& corner : corners_of(mesh, point.cell)) centroid += corner / 4;
  return point.position + step_inside * (centroid - point.position);
}

/// Adds to the parts of a reversed problem what shines as its response does.
struct LitParts {
  const Problem& reversed;
  std::vector<Medium>& media;
  std::vector<Wall>& walls;
  std::vector<Light>& lights;

  PointLight lamp(const std::vector<CellPoint>& cells, double power) const {
    PointLight light;
    light.position = point_inside(reversed.mesh(), cells);
    light.power.assign(static_cast<std::size_t>(reversed.band_count()), power);
    return light;
  }

  void operator()(const PointFluence& point) const {
    lights.push_back({"response", lamp(point.cells, 4 * pi), {}});
  }
  void operator()(const MeanIrradiance& mean) const {
    for (const auto& cells : mean.points) {
      PointLight light = lamp(cells, pi / static_cast<double>(mean.points.size()));
      light.axis = mean.normal;
      for (int i = 0; i <= cosine_steps; ++i) {
        light.angle.push_back(pi / 2 * i / cosine_steps);
        light.intensity.push_back(i < cosine_steps ? std::cos(light.angle.back()) : 0);
      }
      lights.push_back({"response", std::move(light), {}});
    }
  }
  void operator()(const ArrivingPower& at) const {
    Wall& wall = walls[static_cast<std::size_t>(at.wall)];
    wall.radiance.assign(wall.radiance.size(), 1);
    wall.uncollided = Uncollided::automatic;
  }
  void operator()(const AbsorbedPower& in) const {
    Medium& medium = media[static_cast<std::size_t>(in.region)];
    medium.emission = medium.absorption;
    medium.uncollided = Uncollided::automatic;
  }
};

Problem lit_by_response(const Problem& reversed, const Response& response) {
  std::vector<Medium> media(reversed.media().begin(), reversed.media().end());
  std::vector<Wall> walls(reversed.walls().begin(), reversed.walls().end());
  std::vector<Light> lights;
  std::visit(LitParts{reversed, media, walls, lights}, response);
  return Problem(reversed.mesh(), reversed.bands(), std::move(media), std::move(walls), reversed.space(),
                 std::move(lights));
}

/// The problem without scattering, and with walls that reflect as mirrors alone.
Problem without_scattering(const Problem& reversed) {
  std::vector<Medium> media(reversed.media().begin(), reversed.media().end());
  for (Medium& medium : media) {
    medium.scattering.assign(medium.scattering.size(), Coefficient(0.0));
    medium.reradiation.clear();
  }
  std::vector<Wall> walls(reversed.walls().begin(), reversed.walls().end());
  for (Wall& wall : walls) {
    wall.diffuse.assign(wall.diffuse.size(), 0);
    wall.reradiation.clear();
    wall.glossy.clear();
    wall.transmittance.clear();
  }
  return Problem(reversed.mesh(), reversed.bands(), std::move(media), std::move(walls), reversed.space());
}

/// Light of the response on the directions before it collides.
Solution uncollided_on(const Problem& reversed, const DirectionSet& directions, const Response& response,
                       SolveOptions options) {
  const ResponseSource source(reversed, directions, response);
  const Problem black = without_scattering(reversed);
  std::vector<double> extinction(reversed.absorption().begin(), reversed.absorption().end());
  add_to(extinction, reversed.scattering());
  options.angular_input = &source;
  options.meters.clear();
  options.keep_ordinates.clear();
  TransportSweep sweep(black, directions, extinction, options);
  TransportState state(sweep.layout()), next(sweep.layout());
  SweepRecord record;
  for (int bounce = 0; bounce < (sweep.is_direct() ? 1 : most_bounces); ++bounce) {
    sweep.apply(state, next, &record);
    std::swap(state, next);
  }
  Solution solution;
  read_out(sweep, state, record, solution);
  return solution;
}

/// The parts of a solution that take the light along rays.
void add_light(Solution& to, const std::vector<double>& fluence, const std::vector<double>& net_flux,
               const std::vector<double>& irradiance, double factor) {
  add_to(to.fluence, fluence, factor);
  add_to(to.net_flux, net_flux, factor);
  add_to(to.irradiance, irradiance, factor);
}

}  // namespace

std::string follow_uncollided_importance(const Problem& problem, const std::vector<DirectionSet>& sets,
                                         const Response& response, const SolveOptions& options,
                                         Solution& importance, const StageObserver& observer) try {
  if (problem.space() == AngularSpace::plane) return "not in flatland";
  const Problem reversed = reversed_problem(problem, options);
  const Problem lit = lit_by_response(reversed, response);
  const LightSetup lights(lit);
  if (lights.empty()) return "the response is no small wall or region, or rays do not follow walls here";
  const UncollidedField field =
      uncollided_field(lights.paths(), lights.sources(), thread_count(options.threads), observer);
  for (const DirectionSet& directions : sets) {
    const Solution swept = uncollided_on(reversed, directions, response, options);
    add_light(importance, swept.fluence, swept.net_flux, swept.irradiance,
              -1 / static_cast<double>(sets.size()));
  }
  add_light(importance, field.fluence, field.net_flux, field.irradiance, 1);
  return {};
} catch (const InputError&) {
  return "rays do not follow the mirrors, refracting walls or media here";
}

}  // namespace etendue
