// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/conduction.h"

#include <algorithm>

#include "mesh/tetrahedra/corners.h"
#include "solver/heat/cell_conductivity.h"
#include "solver/transport/diffusion/diffusion_matrix.h"

namespace etendue {
namespace {

/// Penalty of a held face times height of the cell: more than 9, which three faces of a
/// cell on walls take for the form to be positive.
constexpr double penalty = 12;

}  // namespace

Conduction::Conduction(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space)
    : problem_(problem), heat_(heat), space_(space) {
  const TetrahedralMesh& mesh = problem.mesh();
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    conductivity_.push_back(space.conductivity(CellIndex(c)));
  find_held();
}

void Conduction::set_temperature(std::span<const double> temperature) {
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    if (!space_.conducts(cell)) continue;
    const HeatMedium& medium = *heat_.media[static_cast<std::size_t>(mesh.region(cell))];
    if (!medium.conductivity.depends_on_temperature()) continue;
    std::array<double, 4> kelvin;
    for (std::size_t i = 0; i < 4; ++i)
      kelvin[i] = temperature[static_cast<std::size_t>(space_.unknown(cell, i))];
    conductivity_[cell.at()] = cell_conductivity(medium, mesh, cell, kelvin);
  }
}

void Conduction::find_held() {
  const TetrahedralMesh& mesh = problem_.mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const auto wall = static_cast<std::size_t>(mesh.wall(face));
    const CellIndex cell = mesh.owner(face);
    if (!(heat_.wall_temperatures[wall] || space_.has(face)) || !space_.conducts(cell)) continue;
    const double area = mesh.area(face), height = 3 * mesh.volume(cell) / area;
    HeldFace held{cell, wall, {}, {}, {}, area, penalty / height, {}};
    const Eigen::Matrix<double, 3, 4> slopes = barycentric_gradients(mesh, cell);
    const Vec3 normal = mesh.area_normal(face).normalized();
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      held.normal_slope[i] = normal.dot(slopes.col(static_cast<Eigen::Index>(i)));
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

void Conduction::add_cell(CellIndex cell, std::span<const double> temperature,
                          std::vector<double>& gains) const {
  const Eigen::Matrix<double, 3, 4> slopes = barycentric_gradients(problem_.mesh(), cell);
  Vec3 gradient = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    gradient += temperature[static_cast<std::size_t>(space_.unknown(cell, i))] *
                slopes.col(static_cast<Eigen::Index>(i));
  const Vec3 flow = problem_.mesh().volume(cell) * conductivity(cell) * gradient;
  for (std::size_t i = 0; i < 4; ++i)
    gains[static_cast<std::size_t>(space_.unknown(cell, i))] -=
        flow.dot(slopes.col(static_cast<Eigen::Index>(i)));
}

/// Flow into a wall at the corners of a face [W/m^2], and the mean difference to what the wall holds [K].
Conduction::WallFlow Conduction::flow_into(const HeldFace& held, std::span<const double> temperature) const {
  WallFlow flow;
  double fall = 0;  // -dT/dn
  for (std::size_t i = 0; i < 4; ++i)
    fall -= held.normal_slope[i] * temperature[static_cast<std::size_t>(space_.unknown(held.cell, i))];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto unknown = static_cast<std::size_t>(space_.unknown(held.cell, held.corners[k]));
    const double of_wall =
        held.unknowns[k] < 0 ? held.temperature[k] : temperature[static_cast<std::size_t>(held.unknowns[k])];
    const double difference = temperature[unknown] - of_wall;
    flow.at[k] = conductivity(held.cell) * (fall + held.penalty * difference);
    flow.mean_difference += difference / 3;
  }
  return flow;
}

void Conduction::add_held(const HeldFace& held, std::span<const double> temperature,
                          std::vector<double>& gains) const {
  const WallFlow flow = flow_into(held, temperature);
  for (std::size_t k = 0; k < 3; ++k) {
    gains[static_cast<std::size_t>(space_.unknown(held.cell, held.corners[k]))] -= held.area / 3 * flow.at[k];
    if (held.unknowns[k] >= 0)
      gains[static_cast<std::size_t>(held.unknowns[k])] += held.area / 3 * flow.at[k];
  }
  for (std::size_t i = 0; i < 4; ++i)
    gains[static_cast<std::size_t>(space_.unknown(held.cell, i))] +=
        held.area * conductivity(held.cell) * held.normal_slope[i] * flow.mean_difference;
}

void Conduction::add_gains(std::span<const double> temperature, std::vector<double>& gains) const {
  for (std::int32_t c = 0; c < problem_.mesh().cell_count(); ++c)
    if (space_.conducts(CellIndex(c))) add_cell(CellIndex(c), temperature, gains);
  for (const HeldFace& held : held_) add_held(held, temperature, gains);
}

std::vector<double> Conduction::conducted(std::span<const double> temperature) const {
  std::vector<double> heat(heat_.wall_temperatures.size(), 0);
  for (const HeldFace& held : held_)
    for (const double flow : flow_into(held, temperature).at) heat[held.wall] += held.area / 3 * flow;
  return heat;
}

}  // namespace etendue
