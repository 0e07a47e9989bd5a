// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "base/vec3.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// A straight line from a point, relative to the middle of a tree, in a unit direction.
struct TreeRay {
  TreeRay(const Vec3& from, const Vec3& along) : origin(from), direction(along) {
    // Across a component of zero a box is met at once or never.
    constexpr double huge = 1e150;
    for (Eigen::Index k = 0; k < 3; ++k) {
      inverse[k] = along[k] == 0 ? huge : 1 / along[k];
      const auto i = static_cast<std::size_t>(k);
      near[i] = (inverse[k] < 0 ? 3 : 0) + i;
      far[i] = (inverse[k] < 0 ? 0 : 3) + i;
    }
  }
  Vec3 origin, direction, inverse;
  std::array<std::size_t, 3> near{}, far{};  ///< of a box, lower bounds before upper ones
};

/// Flat convex polygons in a binary tree of boxes, for rays: faces of a mesh, or pieces that such make up.
class FaceTree {
 public:
  struct Polygon {
    std::int32_t face;          ///< of the mesh, or one of those that make it up
    bool single;                ///< it is that face
    Vec3 normal;                ///< unit
    std::vector<Vec3> corners;  ///< in order, either way about the normal
  };
  static Polygon polygon_of(const TetrahedralMesh& mesh, FaceIndex face);
  /// A line within its plane, from which distances grow inwards.
  struct SideLine {
    Vec3 inwards;  ///< unit
    double offset;
  };
  /// A polygon as rays meet it, relative to the middle of the tree, where rounding is least.
  struct Flat {
    std::int32_t face;
    bool single;
    Vec3 normal;
    double offset;
    std::span<const SideLine> sides;

    double height_of(const Vec3& point) const { return normal.dot(point) - offset; }
    /// How far a point of the plane is from the nearest side [length]: negative beside the polygon.
    double inside(const Vec3& point) const {
      double least = std::numeric_limits<double>::infinity();
      for (const SideLine& side : sides) least = std::min(least, side.inwards.dot(point) - side.offset);
      return least;
    }
  };

  /// Boxes are wider than what is in them by a margin above zero [length].
  FaceTree(std::vector<Polygon> polygons, double margin);
  FaceTree(FaceTree&&) = default;  // what is copied would look into the old one's sides

  std::size_t size() const { return flats_.size(); }
  TreeRay ray(const Vec3& from, const Vec3& direction) const { return {from - middle_, direction}; }
  /// Calls visit(const Flat&) for those that may meet the ray before `limit`, nearer boxes first; visit
  /// may lower the limit.
  template <class Visitor>
  void visit(const TreeRay& ray, const double& limit, Visitor&& visit) const;

 private:
  struct Node {
    std::array<double, 6> box{};  ///< lower bounds, upper bounds
    std::int32_t children = -1;   ///< the first of two of a group; -1: a leaf
    std::int32_t first = 0;       ///< in flats_
    std::int32_t count = 0;
  };
  /// A polygon as the tree is built.
  struct Bounds {
    Eigen::AlignedBox3d box;
    std::size_t polygon;
  };
  void add(const Polygon& polygon);
  void build(std::size_t node, std::span<Bounds> bounds, std::size_t first, double margin);
  /// Where the ray comes into a box before this distance; infinite where it does not.
  static double entry(const std::array<double, 6>& box, const TreeRay& ray, double limit);

  Vec3 middle_ = Vec3::Zero();
  std::vector<Node> nodes_;
  std::vector<SideLine> sides_;
  std::vector<Flat> flats_;
};

inline double FaceTree::entry(const std::array<double, 6>& box, const TreeRay& ray, double limit) {
  // A flat box is met where in and out agree to rounding.
  constexpr double rounding = 1e-12;
  double in = 0, out = limit;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    in = std::max(in, (box[ray.near[k]] - ray.origin[axis]) * ray.inverse[axis]);
    out = std::min(out, (box[ray.far[k]] - ray.origin[axis]) * ray.inverse[axis]);
  }
  return in <= out * (1 + rounding) + std::numeric_limits<double>::min()
             ? in
             : std::numeric_limits<double>::infinity();
}

template <class Visitor>
void FaceTree::visit(const TreeRay& ray, const double& limit, Visitor&& visit) const {
  if (flats_.empty()) return;
  struct Waiting {
    double entry;
    std::int32_t node;
  };
  std::array<Waiting, 64> waiting;  // halved at every level: deeper than any mesh has faces
  std::size_t count = 0;
  const auto push = [&](std::int32_t node) {
    const double at = entry(nodes_[static_cast<std::size_t>(node)].box, ray, limit);
    if (at < std::numeric_limits<double>::infinity()) waiting[count++] = {at, node};
  };
  push(0);
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (next.entry > limit) continue;
    const Node& node = nodes_[static_cast<std::size_t>(next.node)];
    if (node.children < 0) {
      for (const Flat& flat : std::span(flats_).subspan(static_cast<std::size_t>(node.first),
                                                        static_cast<std::size_t>(node.count)))
        visit(flat);
      continue;
    }
    const std::size_t before = count;
    push(node.children);
    push(node.children + 1);
    if (count == before + 2 && waiting[before].entry < waiting[before + 1].entry)
      std::swap(waiting[before], waiting[before + 1]);
  }
}

}  // namespace etendue
