// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/ray_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace etendue {
namespace {

/// Parts of the way to the centroid that a start is moved by, one after the other until the ray is inside.
constexpr std::array<double, 4> start_moves = {1e-11, 1e-9, 1e-6, 1e-3};
/// The first move, in roundings of the largest coordinate: from a wall to a lamp may be very much less far
/// than the cell is long, and the path must not come out shorter than it is.
constexpr double first_move = 16 * std::numeric_limits<double>::epsilon();

}  // namespace

RayMesh::RayMesh(const TetrahedralMesh& mesh) {
  points_.reserve(static_cast<std::size_t>(mesh.vertex_count()));
  for (const Vec3& p : mesh.points()) {
    points_.push_back({p.x(), p.y(), p.z()});
    largest_ = std::max(largest_, p.cwiseAbs().maxCoeff());
  }
  cells_.reserve(static_cast<std::size_t>(mesh.cell_count()));
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    Cell cell{mesh.vertices(CellIndex(c)), {}};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int32_t face = mesh.faces(CellIndex(c))[k];
      const auto& sides = mesh.face_cells()[static_cast<std::size_t>(face)];
      const std::int32_t other = sides[0] == c ? sides[1] : sides[0];
      if (other < 0) {
        cell.across[k] = -1 - face;
        continue;
      }
      const auto& beyond = mesh.faces(CellIndex(other));
      const auto local = std::find(beyond.begin(), beyond.end(), face) - beyond.begin();
      cell.across[k] = 4 * other + static_cast<std::int32_t>(local);
    }
    cells_.push_back(cell);
  }
}

// Both products are nearly the same, so that their difference is exact, and what their rounding took away is
// added: the error of that sum is less than its size unless it is zero.
double RayMesh::area_of_cancelling(const Projected& p, const Projected& q) {
  const double forth = p.x * q.y, back = p.y * q.x;
  const double rest_forth = std::fma(p.x, q.y, -forth), rest_back = std::fma(p.y, q.x, -back);
  return (forth - back) + (rest_forth - rest_back);
}

RayMesh::Frame RayMesh::frame_of(const Vec3& origin, const Vec3& direction) {
  Eigen::Index smallest = 0;
  direction.cwiseAbs().minCoeff(&smallest);
  const Vec3 across = direction.cross(Vec3(Vec3::Unit(smallest))).normalized();
  return {origin, across, direction.cross(across), direction};
}

Vec3 RayMesh::centroid(const Cell& cell) const {
  Vec3 sum = Vec3::Zero();
  for (const std::int32_t vertex : cell.vertices) {
    const Point& p = points_[static_cast<std::size_t>(vertex)];
    sum += Vec3(p.x, p.y, p.z);
  }
  return sum / 4;
}

Vec3 RayMesh::point_of(const Exit& exit) const {
  const double sum = exit.area[0] + exit.area[1] + exit.area[2];
  Vec3 result = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& p = points_[static_cast<std::size_t>(exit.corner[i].vertex)];
    result += (sum > 0 ? exit.area[i] / sum : 1. / 3) * Vec3(p.x, p.y, p.z);
  }
  return result;
}

// Two faces lie on the line of the ray; the farther one is the way out.
bool RayMesh::first_exit(const Frame& frame, const Cell& cell, Exit& exit) const {
  std::array<Projected, 4> p;
  for (std::size_t k = 0; k < 4; ++k) p[k] = project(frame, cell.vertices[k], static_cast<std::int32_t>(k));
  int found = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    Exit candidate;
    candidate.corner = {p[(k + 1) % 4], p[(k + 2) % 4], p[(k + 3) % 4]};
    candidate.opposite = static_cast<std::int32_t>(k);
    auto& [a, b, c] = candidate.corner;
    const bool ab = left_of(area(a, b), a, b), bc = left_of(area(b, c), b, c), ca = left_of(area(c, a), c, a);
    if (ab != bc || bc != ca) continue;
    if (!ab) std::swap(b, c);
    candidate.area = {area(b, c), area(c, a), area(a, b)};
    if (found == 0 || candidate.depth() > exit.depth()) exit = candidate;
    ++found;
  }
  return found == 2 && exit.depth() >= 0;
}

RayMesh::Exit RayMesh::start(CellIndex cell, const Vec3& from, const Vec3& direction, Frame& frame) const {
  const Cell& record = cells_[cell.at()];
  const Vec3 inwards = centroid(record) - from;
  Exit exit;
  frame =
      frame_of(from + std::min(start_moves[0], first_move * largest_ / inwards.norm()) * inwards, direction);
  if (first_exit(frame, record, exit)) return exit;
  for (const double move : start_moves) {
    frame = frame_of(from + move * inwards, direction);
    if (first_exit(frame, record, exit)) return exit;
  }
  throw std::logic_error("a ray starts outside of its cell");
}

}  // namespace etendue
