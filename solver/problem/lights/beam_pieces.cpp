// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/lights/beam_pieces.h"

#include <algorithm>

#include "base/clipped_polygon.h"
#include "base/quadrature/simplex_rules.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

using Triangle = std::array<Vec3, 3>;

/// Side of a piece in radii: of a Gaussian, and of a triangle before it is clipped by a disc.
constexpr double gaussian_side = 0.4, disc_side_length = 2;

/// A triangle in the coordinates of the profile, in radii.
struct Extent {
  Extent(const BeamProfile& profile, const Triangle& t) {
    const Vec3 middle = (t[0] + t[1] + t[2]) / 3;
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 side = t[(i + 1) % 3] - t[i], from = t[i] - middle;
      longest = std::max(longest, std::hypot(profile.across.dot(side), profile.upright.dot(side)));
      reach = std::max(reach, std::hypot(profile.across.dot(from), profile.upright.dot(from)));
    }
    nearest = std::max(0.0, distance_from_axis(profile, middle) - reach);
  }
  double longest = 0, nearest = 0;
};

void add_clipped(const BeamProfile& profile, const Triangle& triangle, std::vector<Triangle>& pieces) {
  std::vector<Vec3> polygon(triangle.begin(), triangle.end());
  for (int side = 0; side < beam_sides && polygon.size() > 2; ++side) {
    const Vec3 normal = disc_side(profile, side);
    polygon = clipped(polygon, -normal, profile.center + disc_apothem() / normal.squaredNorm() * normal);
  }
  for (std::size_t i = 2; i < polygon.size(); ++i) pieces.push_back({polygon[0], polygon[i - 1], polygon[i]});
}

void add_pieces(const BeamProfile& profile, const Triangle& triangle, std::vector<Triangle>& pieces) {
  const bool gaussian = profile.shape == BeamProfile::Shape::gaussian;
  const Extent extent(profile, triangle);
  if (extent.nearest > (gaussian ? gaussian_end : 1 / disc_apothem())) return;
  if (extent.longest > (gaussian ? gaussian_side : disc_side_length)) {
    const auto& [a, b, c] = triangle;
    const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    for (const Triangle& part : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      add_pieces(profile, part, pieces);
  } else if (gaussian) {
    pieces.push_back(triangle);
  } else {
    add_clipped(profile, triangle, pieces);
  }
}

}  // namespace

std::vector<Triangle> beam_pieces(const BeamProfile& profile, const Triangle& triangle) {
  std::vector<Triangle> pieces;
  add_pieces(profile, triangle, pieces);
  return pieces;
}

double mean_profile(const BeamProfile& profile, const Triangle& triangle) {
  double sum = 0;
  for (const Triangle& piece : beam_pieces(profile, triangle))
    for (const FacePointWeight& point : seven_point_rule())
      sum += triangle_area(piece) * point.weight *
             relative_irradiance(profile, point.barycentric[0] * piece[0] + point.barycentric[1] * piece[1] +
                                              point.barycentric[2] * piece[2]);
  return sum / triangle_area(triangle);
}

double entering_area(const BeamLight& beam, const TetrahedralMesh& mesh, FaceIndex face) {
  const double seen = std::max(0.0, -beam.direction.dot(mesh.area_normal(face)));
  if (!beam.profile || seen == 0) return seen;
  return seen * mean_profile(*beam.profile, corners_of(mesh, face));
}

}  // namespace etendue
