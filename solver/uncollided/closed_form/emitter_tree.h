// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "base/index.h"
#include "base/vec3.h"

namespace etendue {

/// A triangle that shines from the side from which its corners stand counterclockwise, or a tetrahedron that
/// emits throughout.
struct EmitterPart {
  std::array<Vec3, 4> corners;  ///< of a triangle three
  std::vector<double>
      brightness;  ///< [band] radiance [power/(length^2 sr)] or emission [power/(length^3 sr)]
  /// [band] inside of a tetrahedron, in the mean over directions [1/length]
  std::vector<double> extinction = {};
  std::optional<CellIndex> cell = {};  ///< that a tetrahedron is
};

/// Corners of a part that is a triangle.
inline std::span<const Vec3> triangle_of(const EmitterPart& part) {
  return std::span(part.corners).first<3>();
}

enum class EmitterShape { triangles, tetrahedra };

/// Parts of a light and groups of them: a binary tree.
class EmitterTree {
 public:
  struct Node {
    Vec3 centre;
    double radius = 0;          ///< of a ball about the centre that holds all of it
    double thickness = 0;       ///< largest extinction inside times the radius
    std::vector<double> total;  ///< [band] brightness times area or volume
    /// Points of equal weight, all of them in the light: of a part those of a rule of degree 2; of a group
    /// eight, or in a plane four, with its mean and spread.
    std::array<Vec3, 8> points{};
    std::size_t point_count = 0;
    Vec3 middle = Vec3::Zero();     ///< the point of the light that is nearest to its centre
    bool hollow = false;            ///< a group that points cannot represent: they would lie beside it
    Vec3 normal = Vec3::Zero();     ///< of triangles; zero where they do not lie in one plane
    int part = -1;                  ///< of a leaf
    std::array<int, 2> children{};  ///< of a group
  };

  EmitterTree(EmitterShape shape, std::vector<EmitterPart> parts);

  EmitterShape shape() const { return shape_; }
  const Node& root() const { return nodes_.front(); }
  const Node& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
  std::span<const EmitterPart> parts() const { return parts_; }
  const EmitterPart& part(int i) const { return parts_[static_cast<std::size_t>(i)]; }
  const Eigen::AlignedBox3d& box() const { return box_; }

 private:
  struct Moments;
  Moments moments_of(const EmitterPart& part) const;
  Moments build(int node, std::span<int> members);
  void place_points(Node& node, const Moments& moments, std::span<const int> members) const;
  Vec3 closest(const Vec3& point, std::span<const int> members) const;
  void finish(Node& node, const Moments& moments, std::span<const int> members) const;

  EmitterShape shape_;
  std::vector<EmitterPart> parts_;
  std::vector<Node> nodes_;
  Eigen::AlignedBox3d box_;
};

}  // namespace etendue
