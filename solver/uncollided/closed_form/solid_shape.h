// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/vec3.h"
#include "solver/uncollided/closed_form/emitter_tree.h"
#include "solver/uncollided/closed_form/solid_angle.h"

namespace etendue {

/// A body with flat faces with uniform emission. What it brings to a point in a homogeneous medium of
/// extinction a, inside of it or outside, depends on its surface alone: with the theorem of Gauss, r from
/// the eye and n outward,
///
///     fluence    int_V e^(-ar) / r^2 dV         = surface int (n.r / r^3) (1 - e^(-ar)) / a dA,
///     net flux   int_V -r e^(-ar) / r^3 dV      = surface int n E_2(ar) / r dA,
///
/// and what a face adds at a height h above or below the eye is an integral along its sides, f being the
/// polar angle about the foot of the eye in its plane:
///
///     int_A (1 - e^(-ar)) / (a r^3) dA          = contour int R(a|h|) - R(ar) df,  R(x) = (1 - E_2(x)) / x,
///     int_A E_2(ar) / r dA                      = contour int r P(ar) - |h| P(a|h|) df,
///                                                 P(x) = (1/2 - E_3(x)) / x.
class SolidShape {
 public:
  struct View {
    double fluence = 0;        ///< over emission [length sr]
    Vec3 flux = Vec3::Zero();  ///< net flux over emission [length sr]
  };

  /// Tetrahedra that share a face have the same corners there.
  explicit SolidShape(std::span<const std::array<Vec3, 4>> tetrahedra);

  /// Through a homogeneous medium of this extinction [1/length]; to 1e-10 of the size.
  View from(const Vec3& eye, double extinction) const;
  /// From a point inside or outside [length].
  double distance_to_surface(const Vec3& point) const;
  /// Those that a point is at most so far from [length].
  std::vector<std::size_t> edges_at(const Vec3& point, double distance) const;
  /// Of the body [length].
  double size() const { return size_; }
  std::size_t edge_count() const { return edges_.size(); }
  std::size_t face_count() const { return faces_.size(); }
  /// Empty if it is not convex.
  std::vector<ConvexFace> convex_faces() const;

 private:
  struct Face {
    Vec3 normal;    ///< outward
    double offset;  ///< normal times any point
  };
  /// Of two faces, about the second of which it runs backwards; of one where the other has it in parts.
  struct Edge {
    Vec3 first, second;
    std::size_t face;
    std::optional<std::size_t> twin;
  };

  double size_ = 0;  ///< [length]
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
};

/// The uniform bodies that tetrahedra make up, with their emission [band]; empty where these have too many
/// edges for that to be worth while.
std::vector<std::pair<SolidShape, std::vector<double>>> solid_shapes(std::span<const EmitterPart> tetrahedra);

}  // namespace etendue
