// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/temperature_fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/case/build/entry_of.h"
#include "app/case/temperatures.h"
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

/// Temperatures of the media of a run.
class MediumTemperatures {
 public:
  explicit MediumTemperatures(const RunResult& result) : result_(result) {
    for (const std::string& name : result.problem.mesh().region_names()) {
      const MediumCase entry = entry_of(result.input.media, name);
      follows_.push_back(entry.iterates_temperature());
      given_.push_back(entry.temperature ? std::optional(coefficient_of(entry.temperature->values.front()))
                                         : std::nullopt);
    }
  }

  /// At a place in a cell, with the fluence there in the first band; 0 where the case gives none [K].
  double at(const CellPoint& place, const Vec3& point, double fluence) const {
    const Problem& problem = result_.problem;
    const auto region = static_cast<std::size_t>(problem.mesh().region(place.cell));
    if (follows_[region] != 0 && result_.heat) return iterated_temperature(*result_.heat, place);
    if (given_[region]) return given_[region]->at(point);
    if (problem.medium(static_cast<int>(region)).reradiation.empty()) return 0;
    return equilibrium_temperature(problem, place.cell, fluence);
  }

 private:
  const RunResult& result_;
  std::vector<char> follows_;                      ///< [region] by iteration
  std::vector<std::optional<Coefficient>> given_;  ///< [region]
};

}  // namespace

double iterated_temperature(const HeatSolution& heat, const CellPoint& place) {
  double kelvin = 0;
  for (std::size_t i = 0; i < 4; ++i)
    kelvin += place.barycentric[i] * heat.temperature[4 * place.cell.at() + i];
  return kelvin;
}

std::vector<double> cell_temperatures(const RunResult& result) {
  const TetrahedralMesh& mesh = result.problem.mesh();
  const MediumTemperatures temperatures(result);
  const std::vector<double> fluence =
      node_means(result.solution.fluence, 4, result.problem.bands().names.size());
  std::vector<double> kelvin;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    kelvin.push_back(
        temperatures.at({cell, {0.25, 0.25, 0.25, 0.25}}, mesh.centroid(cell), fluence[cell.at()]));
  }
  return kelvin;
}

void set_probe_temperatures(const CellLocator& locator, RunResult& result) {
  if (!has_temperatures(result.input)) return;
  const MediumTemperatures temperatures(result);
  for (ProbeRow& row : result.probes)
    for (const CellPoint& place : locator.find(row.point)) {
      const double kelvin = temperatures.at(place, row.point, row.values.front().fluence);
      if (kelvin > 0 && !row.temperature) row.temperature = kelvin;
    }
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
