// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/source/ordinate_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/problem/lights/beam_pieces.h"
#include "solver/problem/lights/lamp_shape.h"
#include "solver/transport/order/projected_area.h"

namespace etendue {
namespace {

/// Pieces of a flat light are this much smaller than the cell they lie in, and no light has more of them.
constexpr double piece_of_cell = 0.25;
constexpr int most_halvings = 8;
/// The cell of a piece is that of a point this part of its size in front of the light: on the side that
/// emits, where the piece lies between cells.
constexpr double before_light = 1e-6;

/// The integral of a shape over the set.
double integral_of(const DirectionSet& directions, std::span<const double> shape) {
  double sum = 0;
  for (std::size_t m = 0; m < shape.size(); ++m) sum += directions.weights()[m] * shape[m];
  return sum;
}

/// The integral of a shape over the set made 1; where no ordinate sees it, all goes along the one that is
/// nearest to its axis.
void normalise(const DirectionSet& directions, const Vec3& axis, std::vector<double>& shape) {
  double sum = integral_of(directions, shape);
  if (!(sum > 0)) {
    std::size_t nearest = 0;
    for (std::size_t m = 1; m < shape.size(); ++m)
      if (directions.directions()[m].dot(axis) > directions.directions()[nearest].dot(axis)) nearest = m;
    shape[nearest] = 1;
    sum = directions.weights()[nearest];
  }
  for (double& value : shape) value /= sum;
}

using Triangle = std::array<Vec3, 3>;

double longest_side(const Triangle& piece) {
  return std::max({(piece[1] - piece[0]).norm(), (piece[2] - piece[1]).norm(), (piece[0] - piece[2]).norm()});
}

/// Calls take(cell, area) for pieces of a triangle that are small beside the cells.
template <class Take>
void cut_up(const TetrahedralMesh& mesh, const CellLocator& locator, const Triangle& piece, int halvings,
            const Take& take) {
  const Vec3 normal = (piece[1] - piece[0]).cross(piece[2] - piece[0]);
  const double side = longest_side(piece);
  const Vec3 middle = (piece[0] + piece[1] + piece[2]) / 3 + before_light * side * normal.normalized();
  const std::vector<CellPoint> found = locator.find(middle);
  if (halvings == most_halvings ||
      (!found.empty() && side < piece_of_cell * std::cbrt(mesh.volume(found.front().cell)))) {
    if (!found.empty()) take(found.front().cell, normal.norm() / 2);
    return;
  }
  const Vec3 a = (piece[0] + piece[1]) / 2, b = (piece[1] + piece[2]) / 2, c = (piece[2] + piece[0]) / 2;
  for (const Triangle& part : {Triangle{piece[0], a, c}, {a, piece[1], b}, {c, b, piece[2]}, {a, b, c}})
    cut_up(mesh, locator, part, halvings + 1, take);
}

}  // namespace

OrdinateLights::OrdinateLights(const Problem& problem, const DirectionSet& directions,
                               const AngularInput* other)
    : problem_(problem),
      directions_(directions),
      other_(other),
      power_inside_(static_cast<std::size_t>(problem.band_count()), 0) {
  for (const Light& light : problem.lights())
    if (light.uncollided == Uncollided::no) std::visit([this](const auto& kind) { add(kind); }, light.kind);
}

void OrdinateLights::add(const PointLight& light) {
  const std::vector<CellPoint> cells = CellLocator(problem_.mesh()).find(light.position);
  const CellIndex cell = cells.front().cell;
  const TangentCone cone(problem_.mesh(), cells);
  std::vector<double>& shape = shapes_.emplace_back();
  for (const Vec3& direction : directions_.directions())
    shape.push_back(cone.contains(direction) ? lamp_shape(light, direction) : 0);
  const double by_volume = 1 / problem_.mesh().volume(cell);
  const double seen = integral_of(directions_, shape);
  points_in_[cell.value()].push_back(
      {&light, cone, seen > 0 ? seen : integral_of_lamp_shape(light), by_volume});
  normalise(directions_, light.axis, shape);
  in_cells_[cell.value()].push_back({light.power, shapes_.size() - 1, by_volume});
  for (std::size_t b = 0; b < power_inside_.size(); ++b) power_inside_[b] += light.power[b];
}

// All triangles lie in one plane and look the same way.
void OrdinateLights::add(const SurfaceLight& light) {
  const CellLocator locator(problem_.mesh());
  const auto corner = [&](std::size_t i) { return light.triangles[i]; };
  const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
  std::vector<double>& shape = shapes_.emplace_back();
  for (const Vec3& direction : directions_.directions())
    shape.push_back(std::max(0.0, direction.dot(normal)));
  normalise(directions_, normal, shape);
  double whole = 0, placed = 0;
  std::unordered_map<std::int32_t, double> areas;
  for (std::size_t i = 0; i + 2 < light.triangles.size(); i += 3) {
    const Triangle triangle{corner(i), corner(i + 1), corner(i + 2)};
    whole += (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm() / 2;
    cut_up(problem_.mesh(), locator, triangle, 0, [&](CellIndex cell, double area) {
      areas[cell.value()] += area;
      placed += area;
    });
  }
  for (const auto& [cell, area] : areas) {
    std::vector<double> power;
    for (const double radiance : light.radiance)
      power.push_back(std::numbers::pi * radiance * area * whole / placed);
    in_cells_[cell].push_back(
        {std::move(power), shapes_.size() - 1, 1 / problem_.mesh().volume(CellIndex(cell))});
  }
  for (std::size_t b = 0; b < power_inside_.size(); ++b)
    power_inside_[b] += std::numbers::pi * light.radiance[b] * whole;
}

void OrdinateLights::add(const BeamLight& light) {
  const TetrahedralMesh& mesh = problem_.mesh();
  power_through_walls_.resize(problem_.walls().size(), std::vector<double>(power_inside_.size(), 0));
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const int wall = mesh.wall(face);
    if (std::ranges::count(light.walls, wall) == 0) continue;
    const double entering = entering_area(light, mesh, face);
    if (entering <= 0) continue;
    std::int32_t nearest = -1;
    for (std::int32_t m = 0; m < directions_.count(); ++m) {
      const Vec3& direction = directions_.directions()[static_cast<std::size_t>(m)];
      if (projected_area(mesh.area_normal(face), direction) < 0 &&
          (nearest < 0 || direction.dot(light.direction) >
                              directions_.direction(OrdinateIndex(nearest)).dot(light.direction)))
        nearest = m;
    }
    const OrdinateIndex m(nearest);
    const double projected = -projected_area(mesh.area_normal(face), directions_.direction(m));
    FacePart part{nearest, {}};
    for (std::size_t b = 0; b < power_inside_.size(); ++b) {
      part.radiance.push_back(light.irradiance[b] * entering / (directions_.weight(m) * projected));
      power_through_walls_[static_cast<std::size_t>(wall)][b] += light.irradiance[b] * entering;
    }
    at_faces_[f].push_back(std::move(part));
  }
}

bool OrdinateLights::depends_on_direction(CellIndex cell) const {
  return in_cells_.contains(cell.value()) || (other_ != nullptr && other_->depends_on_direction(cell));
}

void OrdinateLights::add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const {
  if (other_ != nullptr) other_->add_source(m, cell, values);
  const auto parts = in_cells_.find(cell.value());
  if (parts == in_cells_.end()) return;
  const std::size_t bands = power_inside_.size();
  for (const CellPart& part : parts->second)
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] += part.power[i % bands] * part.by_volume * shapes_[part.shape][m.at()];
}

void OrdinateLights::add_points(const Vec3& travel, CellIndex cell, std::span<double> values) const {
  const auto points = points_in_.find(cell.value());
  if (points == points_in_.end()) return;
  const std::size_t bands = power_inside_.size();
  for (const PointShape& point : points->second) {
    if (!point.cone.contains(travel)) continue;
    const double density = lamp_shape(*point.light, travel) / point.integral * point.by_volume;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += point.light->power[i % bands] * density;
  }
}

void OrdinateLights::add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const {
  if (other_ != nullptr) other_->add_inflow(m, face, values);
  const auto parts = at_faces_.find(face.value());
  if (parts == at_faces_.end()) return;
  const std::size_t bands = power_inside_.size();
  for (const FacePart& part : parts->second)
    for (std::size_t i = 0; i < values.size() && part.ordinate == m.value(); ++i)
      values[i] += part.radiance[i % bands];
}

}  // namespace etendue
