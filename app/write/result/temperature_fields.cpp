// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/temperature_fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "app/case/build/entry_of.h"
#include "app/case/values/value_algebra.h"
#include "base/blackbody.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/solution/node_means.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Of a gray body with this emissive power n^2 sigma T^4 [W/m^2].
double temperature_of(double emissive_power, const Bands& bands) {
  return std::pow(
      std::max(0.0, emissive_power) / (bands.refractive_index * bands.refractive_index * stefan_boltzmann),
      0.25);
}

/// In radiative equilibrium: 4 kappa sigma T^4 = kappa G + heat source (Modest, Radiative Heat Transfer,
/// section 14.3), with the fluence G.
double equilibrium_temperature(const Problem& problem, CellIndex cell, double fluence) {
  const Medium& medium = problem.medium(problem.mesh().region(cell));
  const double kappa = medium.reradiation.front().cell_mean(corners_of(problem.mesh(), cell));
  return kappa > 0 ? temperature_of(fluence / 4 + pi * problem.emission(cell, 0) / kappa, problem.bands())
                   : 0;
}

/// Of values [cell][4], at the centroid of a cell.
double mean_of_vertices(const std::vector<double>& values, CellIndex cell) {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(4 * cell.at());
  return std::accumulate(first, first + 4, 0.0) / 4;
}

}  // namespace

std::vector<double> cell_temperatures(const RunResult& result) {
  const Problem& problem = result.problem;
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<std::optional<Coefficient>> given;
  std::vector<char> follows;
  for (const std::string& name : mesh.region_names()) {
    const MediumCase entry = entry_of(result.input.media, name);
    follows.push_back(entry.iterates_temperature());
    given.push_back(entry.temperature ? std::optional(coefficient_of(entry.temperature->values.front()))
                                      : std::nullopt);
  }
  const std::vector<double> fluence = node_means(result.solution.fluence, 4, problem.bands().names.size());
  std::vector<double> kelvin(static_cast<std::size_t>(mesh.cell_count()), 0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (follows[static_cast<std::size_t>(mesh.region(cell))] != 0 && result.heat)
      kelvin[cell.at()] = mean_of_vertices(result.heat->temperature, cell);
    else if (const auto& formula = given[static_cast<std::size_t>(mesh.region(cell))])
      kelvin[cell.at()] = formula->at(mesh.centroid(cell));
    else if (!problem.medium(mesh.region(cell)).reradiation.empty())
      kelvin[cell.at()] = equilibrium_temperature(problem, cell, fluence[cell.at()]);
  }
  return kelvin;
}

WallTemperature::WallTemperature(const RunResult& result, int wall) : bands_(result.problem.bands()) {
  const Wall& behind = result.problem.wall(wall);
  const WallCase entry = entry_of(result.input.walls, behind.name);
  // That of a smooth surface is what is behind it.
  if (entry.temperature && entry.refractive_index == 1)
    given_ = coefficient_of(entry.temperature->values.front());
  if (entry.iterates_temperature() && result.heat) iterated_ = result.heat->wall_temperature;
  if (!entry.reradiates) return;
  emissivity_ = behind.reradiation.front();
  heat_flux_ = *entry.heat_flux;
}

// A wall that gives the heat flux q: epsilon sigma T^4 = epsilon H + q.
double WallTemperature::at(const Vec3& point, double irradiance, std::size_t corner) const {
  if (!iterated_.empty()) return iterated_[corner];
  if (given_) return given_->at(point);
  return emissivity_ > 0 ? temperature_of(irradiance + heat_flux_ / emissivity_, bands_) : 0;
}

std::vector<WallTemperature> wall_temperatures(const RunResult& result) {
  std::vector<WallTemperature> walls;
  for (int wall = 0; wall < static_cast<int>(result.problem.walls().size()); ++wall)
    walls.emplace_back(result, wall);
  return walls;
}

std::vector<double> vertex_temperatures_of_walls(const RunResult& result) {
  const std::vector<WallTemperature> walls = wall_temperatures(result);
  const TetrahedralMesh& mesh = result.problem.mesh();
  const auto bands = static_cast<std::size_t>(result.problem.band_count());
  std::vector<double> kelvin;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      kelvin.push_back(walls[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))].at(
          corner_of(mesh, FaceIndex(f), i), result.solution.irradiance[kelvin.size() * bands],
          kelvin.size()));
  return kelvin;
}

}  // namespace etendue
