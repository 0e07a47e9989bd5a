// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/heat_balance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/blackbody.h"
#include "base/errors.h"
#include "base/field_view.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/problem/band_blackbody.h"
#include "solver/transport/diffusion/diffusion_matrix.h"

namespace etendue {
namespace {

/// Conductance of a held face times height of the cell over conductivity: more than 9, which three faces of a
/// cell on walls take for the form to be positive.
constexpr double penalty = 12;

}  // namespace

double absorption_of_all_bands(const Problem& problem, CellIndex cell) {
  double sum = 0;
  for (int band = 0; band < problem.band_count(); ++band) sum += problem.absorption(cell, band);
  return sum;
}

HeatBalance::HeatBalance(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space)
    : problem_(problem), heat_(heat), space_(space), volumes_(space.size(), 0), walls_(problem, heat, space) {
  const TetrahedralMesh& mesh = problem.mesh();
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < 4 && space.has(CellIndex(c)); ++i)
      volumes_[static_cast<std::size_t>(space.unknown(CellIndex(c), i))] += mesh.volume(CellIndex(c)) / 4;
  for (const FollowingFace& face : walls_.faces())
    for (const std::size_t unknown : face.unknowns)
      volumes_[unknown] = mesh.volume(mesh.owner(face.face)) / 4;
  find_sources();
  find_held();
}

void HeatBalance::find_sources() {
  const TetrahedralMesh& mesh = problem_.mesh();
  sources_.assign(static_cast<std::size_t>(4 * mesh.cell_count()), 0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (!space_.has(cell)) continue;
    const HeatMedium& medium = *heat_.media[static_cast<std::size_t>(mesh.region(cell))];
    const CellSample source = medium.source.sample(corners_of(mesh, cell));
    if (!std::isfinite(source.mean) || !(source.smallest >= 0))
      throw InputError(
          fault_at(medium.origin, "heat_source",
                   fmt::format("is {:g} at ({:.6g}, {:.6g}, {:.6g}); use at least 0", source.smallest,
                               source.where.x(), source.where.y(), source.where.z())));
    for (std::size_t i = 0; i < 4; ++i) sources_[4 * cell.at() + i] = source.mean + source.slope[i];
  }
}

void HeatBalance::find_held() {
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const auto wall = static_cast<std::size_t>(mesh.wall(face));
    const CellIndex cell = mesh.owner(face);
    if (!(heat_.wall_temperatures[wall] || space_.has(face)) || !space_.conducts(cell)) continue;
    const double area = mesh.area(face), height = 3 * mesh.volume(cell) / area;
    const double conductivity = space_.conductivity(cell);
    HeldFace held{cell, wall, {}, {}, {}, area, penalty * conductivity / height, {}};
    const Eigen::Matrix<double, 3, 4> slopes = barycentric_gradients(mesh, cell);
    const Vec3 normal = mesh.area_normal(face).normalized();
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      held.normal_flow[i] = conductivity * normal.dot(slopes.col(static_cast<Eigen::Index>(i)));
      const auto on_face = std::ranges::find(mesh.vertices(face), mesh.vertices(cell)[i]);
      if (on_face == mesh.vertices(face).end()) continue;
      held.unknowns[count] =
          space_.unknown(face, static_cast<std::size_t>(on_face - mesh.vertices(face).begin()));
      if (held.unknowns[count] < 0)
        held.temperature[count] = heat_.wall_temperatures[wall]->at(corner_of(mesh, cell, i));
      held.corners[count++] = i;
    }
    held_.push_back(held);
  }
}

Blackbodies HeatBalance::blackbodies(std::span<const double> temperature) const {
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  Blackbodies result{std::vector<double>(temperature.size() * bands),
                     std::vector<double>(temperature.size() * bands)};
  for (std::size_t i = 0; i < result.radiance.size(); ++i) {
    const int band = static_cast<int>(i % bands);
    const double kelvin = std::abs(temperature[i / bands]);
    result.radiance[i] =
        std::copysign(band_blackbody(problem_.bands(), band, kelvin), temperature[i / bands]);
    result.slope[i] = stefan_boltzmann / std::numbers::pi * space_.power_per_value(i / bands, kelvin) *
                      band_share_of_change(problem_.bands(), band, kelvin);
  }
  return result;
}

FollowingSources HeatBalance::sources(const Blackbodies& blackbodies) const {
  return {emission(blackbodies), walls_.radiance(blackbodies)};
}

CellEmission HeatBalance::emission(const Blackbodies& blackbodies) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  CellEmission emission(static_cast<std::size_t>(mesh.cell_count()), bands);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    for (std::size_t band = 0; band < bands && space_.has(cell); ++band) {
      std::array<double, 4> values = {};
      double mean = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto unknown = static_cast<std::size_t>(space_.unknown(cell, i));
        values[i] =
            problem_.absorption(cell, static_cast<int>(band)) * blackbodies.radiance[unknown * bands + band];
        mean += values[i] / 4;
      }
      for (double& value : values) value -= mean;
      emission.add(cell, band, mean, values);
    }
  }
  return emission;
}

void HeatBalance::add_conduction(CellIndex cell, std::span<const double> temperature,
                                 std::vector<double>& gains) const {
  const Eigen::Matrix<double, 3, 4> slopes = barycentric_gradients(problem_.mesh(), cell);
  Vec3 gradient = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    gradient += temperature[static_cast<std::size_t>(space_.unknown(cell, i))] *
                slopes.col(static_cast<Eigen::Index>(i));
  const Vec3 flow = problem_.mesh().volume(cell) * space_.conductivity(cell) * gradient;
  for (std::size_t i = 0; i < 4; ++i)
    gains[static_cast<std::size_t>(space_.unknown(cell, i))] -=
        flow.dot(slopes.col(static_cast<Eigen::Index>(i)));
}

std::vector<double> HeatBalance::gains(std::span<const double> temperature, const Blackbodies& blackbodies,
                                       const LightAtVertices& light) const {
  const TetrahedralMesh& mesh = problem_.mesh();
  const auto bands = static_cast<std::size_t>(problem_.band_count());
  const ConstCellField fluence(light.fluence, bands);
  std::vector<double> gains(space_.size(), 0);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (!space_.has(cell)) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto unknown = static_cast<std::size_t>(space_.unknown(cell, i));
      double density = sources_[4 * cell.at() + i];
      for (std::size_t band = 0; band < bands; ++band)
        density +=
            problem_.absorption(cell, static_cast<int>(band)) *
            (fluence(cell, i, band) - 4 * std::numbers::pi * blackbodies.radiance[unknown * bands + band]);
      gains[unknown] += mesh.volume(cell) / 4 * density;
    }
    if (space_.conducts(cell)) add_conduction(cell, temperature, gains);
  }
  for (const HeldFace& held : held_) add_held(held, temperature, gains);
  walls_.add_gains(temperature, blackbodies, light, gains);
  return gains;
}

/// Flow into a wall at the corners of a face [W/m^2], and the mean difference to what the wall holds [K].
HeatBalance::WallFlow HeatBalance::flow_into(const HeldFace& held,
                                             std::span<const double> temperature) const {
  WallFlow flow;
  double conducted = 0;
  for (std::size_t i = 0; i < 4; ++i)
    conducted -= held.normal_flow[i] * temperature[static_cast<std::size_t>(space_.unknown(held.cell, i))];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto unknown = static_cast<std::size_t>(space_.unknown(held.cell, held.corners[k]));
    const double of_wall =
        held.unknowns[k] < 0 ? held.temperature[k] : temperature[static_cast<std::size_t>(held.unknowns[k])];
    const double difference = temperature[unknown] - of_wall;
    flow.at[k] = conducted + held.conductance * difference;
    flow.mean_difference += difference / 3;
  }
  return flow;
}

void HeatBalance::add_held(const HeldFace& held, std::span<const double> temperature,
                           std::vector<double>& gains) const {
  const WallFlow flow = flow_into(held, temperature);
  for (std::size_t k = 0; k < 3; ++k) {
    gains[static_cast<std::size_t>(space_.unknown(held.cell, held.corners[k]))] -= held.area / 3 * flow.at[k];
    if (held.unknowns[k] >= 0)
      gains[static_cast<std::size_t>(held.unknowns[k])] += held.area / 3 * flow.at[k];
  }
  for (std::size_t i = 0; i < 4; ++i)
    gains[static_cast<std::size_t>(space_.unknown(held.cell, i))] +=
        held.area * held.normal_flow[i] * flow.mean_difference;
}

std::vector<double> HeatBalance::conducted(std::span<const double> temperature) const {
  std::vector<double> heat(heat_.wall_temperatures.size(), 0);
  for (const HeldFace& held : held_)
    for (const double flow : flow_into(held, temperature).at) heat[held.wall] += held.area / 3 * flow;
  return heat;
}

}  // namespace etendue
