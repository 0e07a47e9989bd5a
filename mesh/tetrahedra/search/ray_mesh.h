// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Where a walk ended: at its length, or before that at a face of the boundary.
struct RayEnd {
  double distance = 0;                 ///< from the start [length]
  CellIndex cell = CellIndex(0);       ///< the last one
  std::optional<FaceIndex> wall = {};  ///< the face where the ray left the domain; empty: it did not
  Vec3 point = Vec3::Zero();           ///< where it left: in the last face, however flat the ray meets it
};

/// The mesh as rays see it: 32 bytes for each cell and for each vertex. A ray goes from cell to cell through
/// the face whose edges it passes on the right side. What side of an edge the ray passes is computed from the
/// two projected ends of that edge alone, and so comes out the same in all cells around it; where the ray
/// meets an edge or a vertex, the ray is thought to be moved by infinitely little, the same way everywhere
/// (Edelsbrunner and Mücke 1990). So no ray slips out between two cells, and none stands still (compare Lagae
/// and Dutré 2008).
class RayMesh {
 public:
  explicit RayMesh(const TetrahedralMesh& mesh);

  /// Walks from a point of a cell along the unit vector `direction` and calls visit(CellIndex, double length)
  /// for each cell on the path, in order, until `length` is covered or the ray leaves the domain: it does not
  /// come back in. The start may lie on a face, an edge or a vertex of its cell: it is moved into it, by as
  /// little as rounding lets.
  template <class Visitor>
  RayEnd walk(CellIndex start, const Vec3& from, const Vec3& direction, double length,
              Visitor&& visit) const {
    const auto any = [](CellIndex, double) { return true; };
    return walk_while(start, from, direction, length, visit, any).end;
  }
  /// The same as long as enter(CellIndex, double distance) holds for the cell that the ray comes into there.
  /// Where it does not, the end is where that cell begins, and it is the cell of the end.
  struct PartOfPath {
    RayEnd end;
    int entered =
        -1;  ///< the local face by which the ray came into the cell that it stopped before; -1: none
  };
  template <class Visitor, class Condition>
  PartOfPath walk_while(CellIndex start, const Vec3& from, const Vec3& direction, double length,
                        Visitor&& visit, Condition&& enter) const;

 private:
  struct alignas(32) Cell {
    std::array<std::int32_t, 4> vertices;
    /// 4 × neighbour + its vertex opposite the face, or -1 - boundary face
    std::array<std::int32_t, 4> across;
  };
  struct alignas(32) Point {
    double x, y, z;
  };
  /// A vertex in the frame of the ray: x, y across, z along it; its number in the cell and in the mesh.
  struct Projected {
    double x, y, z;
    std::int32_t local, vertex;
  };
  struct Frame {
    Vec3 origin, across, up, along;
  };
  /// The face that the ray leaves a cell by: corners counterclockwise about the ray, twice the areas that it
  /// cuts off (edge bc of a, …), the vertex opposite.
  struct Exit {
    std::array<Projected, 3> corner;
    std::array<double, 3> area;
    std::int32_t opposite = 0;
    double depth() const;
  };

  static Frame frame_of(const Vec3& origin, const Vec3& direction);
  Projected project(const Frame& frame, std::int32_t vertex, std::int32_t local) const;
  /// Twice the area of the triangle of the ray and the edge from p to q, of the sign that it has exactly:
  /// were signs of rounding taken, those of a vertex's edges could contradict each other.
  static double area(const Projected& p, const Projected& q);
  static double area_of_cancelling(const Projected& p, const Projected& q);
  /// Whether the ray has the edge from p to q on its left. area(p, q) = -area(q, p) to the last bit.
  static bool left_of(double area, const Projected& p, const Projected& q);
  /// The way out of the first cell.
  bool first_exit(const Frame& frame, const Cell& cell, Exit& exit) const;
  Exit start(CellIndex cell, const Vec3& from, const Vec3& direction, Frame& frame) const;
  Vec3 centroid(const Cell& cell) const;
  Vec3 point_of(const Exit& exit) const;
  /// A straight line meets a cell once.
  std::size_t step_limit() const { return cells_.size() + 1; }
  /// Replaces the corner that the ray's way out of the next cell does not have.
  static void turn(Exit& exit, const Projected& next);

  std::vector<Cell> cells_;
  std::vector<Point> points_;
  double largest_ = 0;  ///< coordinate [length]
};

inline RayMesh::Projected RayMesh::project(const Frame& frame, std::int32_t vertex,
                                           std::int32_t local) const {
  const Point& p = points_[static_cast<std::size_t>(vertex)];
  const double x = p.x - frame.origin[0], y = p.y - frame.origin[1], z = p.z - frame.origin[2];
  return {x * frame.across[0] + y * frame.across[1] + z * frame.across[2],
          x * frame.up[0] + y * frame.up[1] + z * frame.up[2],
          x * frame.along[0] + y * frame.along[1] + z * frame.along[2], local, vertex};
}

inline double RayMesh::area(const Projected& p, const Projected& q) {
  constexpr double cancelled = 8 * std::numeric_limits<double>::epsilon();
  const double forth = p.x * q.y, back = p.y * q.x;
  const double difference = forth - back;
  return std::abs(difference) > cancelled * std::abs(forth) ? difference : area_of_cancelling(p, q);
}

// With the ray moved by (e, e²) for an infinitely small e, the area becomes
// area + e (p.y - q.y) - e² (p.x - q.x); ends that coincide are told apart by their numbers.
inline bool RayMesh::left_of(double area, const Projected& p, const Projected& q) {
  if (area != 0) return area > 0;
  if (p.y != q.y) return p.y > q.y;
  if (p.x != q.x) return p.x < q.x;
  return p.vertex < q.vertex;
}

inline double RayMesh::Exit::depth() const {
  return (area[0] * corner[0].z + area[1] * corner[1].z + area[2] * corner[2].z) /
         (area[0] + area[1] + area[2]);
}

// With the face abc behind it and the vertex d ahead, the ray leaves by that one of abd, bcd, cad that it
// passes inside: it has exactly one edge to d on its left and the next on its right.
inline void RayMesh::turn(Exit& exit, const Projected& next) {
  std::array<double, 3> to_next;
  std::array<bool, 3> left;
  for (std::size_t i = 0; i < 3; ++i) {
    to_next[i] = area(exit.corner[i], next);
    left[i] = left_of(to_next[i], exit.corner[i], next);
  }
  // The face of the corners i, i + 1 and d is the way out where left is false at i and true at i + 1.
  const std::size_t i = !left[0] ? (left[1] ? 0 : 1) : (!left[2] ? 2 : 1);
  const std::size_t j = i == 2 ? 0 : i + 1;
  const std::size_t k = 3 - i - j;
  exit.opposite = exit.corner[k].local;
  exit.corner[k] = next;
  // area[k] of the edge ij stays.
  exit.area[i] = to_next[j];
  exit.area[j] = -to_next[i];
}

template <class Visitor, class Condition>
RayMesh::PartOfPath RayMesh::walk_while(CellIndex start_cell, const Vec3& from, const Vec3& direction,
                                        double length, Visitor&& visit, Condition&& enter) const {
  Frame frame;
  Exit exit = start(start_cell, from, direction, frame);
  std::int32_t cell = start_cell.value();
  double reached = 0;
  for (std::size_t step = 0; step < step_limit(); ++step) {
    const double depth = exit.depth();
    // Not a number where the ray lies in the face.
    const double next = depth > reached ? depth : reached;
    if (next >= length) {
      visit(CellIndex(cell), length - reached);
      return {{length, CellIndex(cell), {}}};
    }
    visit(CellIndex(cell), next - reached);
    reached = next;
    const std::int32_t across =
        cells_[static_cast<std::size_t>(cell)].across[static_cast<std::size_t>(exit.opposite)];
    if (across < 0) return {{reached, CellIndex(cell), FaceIndex(-1 - across), point_of(exit)}};
    cell = across >> 2;
    if (!enter(CellIndex(cell), reached)) return {{reached, CellIndex(cell), {}, point_of(exit)}, across & 3};
    const Cell& record = cells_[static_cast<std::size_t>(cell)];
    const std::int32_t opposite = across & 3;
    // Vertices are sorted in all cells: the face's corners are in the same order on its other side.
    for (Projected& corner : exit.corner) {
      const std::int32_t rank = corner.local - (corner.local > exit.opposite);
      corner.local = rank + (rank >= opposite);
    }
    turn(exit, project(frame, record.vertices[static_cast<std::size_t>(opposite)], opposite));
  }
  throw std::logic_error("a ray goes in a circle");
}

}  // namespace etendue
