// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/vec3.h"
#include "solver/uncollided/closed_form/emitter_tree.h"

namespace etendue {

/// Solid angle of a triangle seen from the origin [sr], positive where its corners stand counterclockwise
/// (van Oosterom and Strackee 1983, eq. 8).
double signed_solid_angle(const std::array<Vec3, 3>& corners);

/// A flat piece of any outline with uniform radiance on one side. What it brings to a point in empty space
/// depends on its outline alone, and so it does in a homogeneous medium.
class FlatShape {
 public:
  struct View {
    double fluence = 0;        ///< over radiance, the solid angle in empty space [sr]
    Vec3 flux = Vec3::Zero();  ///< net flux over radiance [sr]
  };

  /// Triangles in one plane; those that share a side have it turned round.
  explicit FlatShape(std::span<const std::array<Vec3, 3>> triangles);

  /// Through empty space (Lambert 1760; Arvo 1994, eq. 4). Nothing from behind and from its plane.
  View from(const Vec3& eye) const;
  /// Through a homogeneous medium of this extinction [1/length].
  View from(const Vec3& eye, double extinction) const;
  /// Those that a point is at most so far from [length].
  std::vector<std::size_t> sides_at(const Vec3& point, double distance) const;
  std::size_t side_count() const { return sides_.size(); }

 private:
  /// Of the eye above the plane; zero if it is behind or in it.
  double height(const Vec3& eye) const;
  View by_parts(const Vec3& eye, double height, double extinction) const;
  View by_sides(const Vec3& eye, double height, double extinction) const;

  Vec3 normal_;
  double size_ = 0;                           ///< [length]
  std::vector<std::pair<Vec3, Vec3>> sides_;  ///< counterclockwise about the normal
};

/// The uniform shapes that triangles make up, with their radiance [band]; empty where they are more than a
/// few, or have many sides.
std::vector<std::pair<FlatShape, std::vector<double>>> flat_shapes(std::span<const EmitterPart> triangles);

}  // namespace etendue
