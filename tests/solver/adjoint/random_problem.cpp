// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/adjoint/random_problem.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "solver/materials/surfaces/phong.h"
#include "solver/solution/balance.h"
#include "solver/solution/probe.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue {
namespace {

constexpr std::size_t bands = 3;

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  Vec3 inside(double low, double high) {
    const double x = between(low, high), y = between(low, high), z = between(low, high);
    return {x, y, z};
  }
  std::vector<double> each(double low, double high) {
    std::vector<double> values(bands);
    for (double& value : values) value = between(low, high);
    return values;
  }
  std::vector<Coefficient> coefficients(double low, double high) {
    const std::vector<double> values = each(low, high);
    return {values.begin(), values.end()};
  }

 private:
  std::mt19937 random_;
};

PhaseFunction random_phase(Dice& dice) {
  const double choice = dice.between(0, 1);
  if (choice < 0.4) return PhaseIsotropic{};
  return PhaseHenyeyGreenstein{dice.between(-0.4, 0.5)};
}

Medium random_medium(Dice& dice, const std::string& name, double thickness) {
  Medium medium = uniform_medium(bands, 0, 0, 0);
  medium.name = name;
  medium.absorption = dice.coefficients(0.05, 0.5 * thickness);
  medium.scattering = dice.coefficients(0, thickness);
  medium.emission = dice.coefficients(0, 1);
  medium.emission[1] = Coefficient(Expression("1 + x*y + z", {"x", "y", "z"}));
  for (PhaseFunction& phase : medium.phase) phase = random_phase(dice);
  return medium;
}

Wall random_wall(Dice& dice, const std::string& name, Rays rays) {
  Wall wall = uniform_wall(bands, 0, 0, 0);
  wall.name = name;
  wall.diffuse = dice.each(0, 0.5);
  // Light along rays does not go between mirrors that face each other.
  if (name.ends_with("min")) wall.specular = dice.each(0, 0.3);
  if (dice.between(0, 1) < 0.5) wall.radiance = dice.each(0, 1);
  // Lobes take light along rays as the sum of all that arrives, which is not the sum of their parts.
  if (dice.between(0, 1) < 0.3 && rays != Rays::from_all) {
    wall.specular.assign(bands, 0);
    wall.glossy.assign(bands, std::make_shared<Phong>(dice.between(0.1, 0.4), dice.between(1, 8)));
  }
  return wall;
}

std::vector<Light> random_lights(Dice& dice, const TetrahedralMesh& mesh, Rays rays) {
  PointLight lamp, swept;
  lamp.position = dice.inside(0.1, 0.9);
  lamp.power = dice.each(0.1, 2);
  swept.position = dice.inside(0.1, 0.9);
  swept.power = dice.each(0.1, 2);
  BeamLight beam;
  beam.direction = Vec3(0.2, -0.3, -1).normalized();
  beam.irradiance = dice.each(0.1, 1);
  const auto names = mesh.wall_names();
  beam.walls = {static_cast<int>(std::ranges::find(names, "zmax") - names.begin())};
  const auto along_rays = [](bool yes) { return yes ? Uncollided::automatic : Uncollided::no; };
  return {{"lamp", lamp, {}, along_rays(rays != Rays::none)},
          {"swept", swept, {}, Uncollided::no},
          {"beam", beam, {}, along_rays(rays == Rays::from_all)}};
}

/// The values of a run for each kind of response.
struct ReadRun {
  const Problem& problem;
  const LightSetup& lights;
  const Solution& solution;

  std::vector<double> operator()(const PointFluence& point) const {
    Vec3 position = Vec3::Zero();
    const CellPoint& place = point.cells.front();
    for (std::size_t k = 0; k < 4; ++k)
      position +=
          place.barycentric[k] * problem.mesh().point(VertexIndex(problem.mesh().vertices(place.cell)[k]));
    const CellLocator locator(problem.mesh());
    std::vector<double> values;
    for (const ProbeValue& value : probe(problem, solution, locator, position))
      values.push_back(value.fluence);
    if (lights.empty()) return values;
    const auto projected = probe_uncollided(problem, solution, locator, position);
    const LightAtPoint exact = lights.at({place.cell, position}, std::nullopt);
    for (std::size_t b = 0; b < values.size(); ++b) values[b] += exact.fluence[b] - projected[b].fluence;
    return values;
  }
  std::vector<double> operator()(const MeanIrradiance& mean) const {
    std::vector<double> values(bands, 0);
    for (std::size_t i = 0; i < solution.meters.size(); ++i)
      values[i % bands] += solution.meters[i] / static_cast<double>(mean.points.size());
    return values;
  }
  std::vector<double> operator()(const ArrivingPower& at) const {
    std::vector<double> values;
    const auto walls = wall_powers(problem, solution);
    for (const WallPower& power : walls[static_cast<std::size_t>(at.wall)]) values.push_back(power.incoming);
    return values;
  }
  std::vector<double> operator()(const AbsorbedPower& in) const {
    std::vector<double> values;
    const auto regions = region_powers(problem, solution);
    for (const RegionPower& power : regions[static_cast<std::size_t>(in.region)])
      values.push_back(power.absorbed);
    return values;
  }
};

}  // namespace

Problem random_problem(const TetrahedralMesh& mesh, unsigned seed, Rays rays,
                       const std::function<void(std::vector<Medium>&, std::vector<Wall>&)>& change) {
  Dice dice(seed);
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names())
    media.push_back(random_medium(dice, name, name == "inner" ? 20 : 2));
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) walls.push_back(random_wall(dice, name, rays));
  // A beam enters through walls that do not mirror.
  for (Wall& wall : walls)
    if (wall.name == "zmax") wall.specular.assign(bands, 0);
  if (change) change(media, walls);
  Bands names;
  names.names = {"red", "green", "blue"};
  std::vector<Light> lights = random_lights(dice, mesh, rays);
  return Problem(mesh, names, media, walls, AngularSpace::sphere, std::move(lights));
}

std::vector<Response> random_responses(const TetrahedralMesh& mesh, unsigned seed) {
  Dice dice(seed + 1000);
  const CellLocator locator(mesh);
  const Vec3 normal = dice.inside(-1, 1).normalized();
  return {
      PointFluence{locator.find(dice.inside(0.05, 0.95))},
      MeanIrradiance{{locator.find(dice.inside(0.05, 0.95)), locator.find(dice.inside(0.05, 0.95))}, normal},
      ArrivingPower{static_cast<int>(dice.between(0, 6))},
      AbsorbedPower{static_cast<int>(dice.between(0, static_cast<double>(mesh.region_names().size())))}};
}

std::vector<std::vector<double>> responses_of_run(const Problem& problem, const DirectionSet& directions,
                                                  const std::vector<Response>& responses,
                                                  SolveOptions options) {
  for (const Response& response : responses)
    if (const auto* mean = std::get_if<MeanIrradiance>(&response))
      for (const auto& cells : mean->points) options.meters.push_back({cells, mean->normal});
  const LightSetup lights(problem);
  const Solution solution = solve_split(lights, directions, options);
  std::vector<std::vector<double>> values;
  for (const Response& response : responses)
    values.push_back(std::visit(ReadRun{problem, lights, solution}, response));
  return values;
}

std::vector<double> duality_errors(const Problem& problem, const DirectionSet& directions,
                                   const std::vector<Response>& responses, const SolveOptions& options) {
  const auto forward = responses_of_run(problem, directions, responses, options);
  const auto emitters = emitter_sources(problem, options.threads);
  std::vector<double> errors;
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const std::vector<double> backward =
        solve_adjoint(emitters, problem, {directions}, responses[i], options).response();
    double largest = forward[i].size() == bands && backward.size() == bands ? 0 : 1;
    for (std::size_t b = 0; b < std::min(forward[i].size(), backward.size()); ++b)
      largest = std::max(largest, std::abs(backward[b] - forward[i][b]) / std::abs(forward[i][b]));
    errors.push_back(largest);
  }
  return errors;
}

}  // namespace etendue
