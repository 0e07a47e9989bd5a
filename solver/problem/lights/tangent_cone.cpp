// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/lights/tangent_cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mesh/tetrahedra/bounding_box.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Distance from a face, relative to the domain's diagonal, up to which a point lies on the face: that of
/// CellLocator.
constexpr double on_face = 1e-9;
/// Solid angles that differ from the whole sphere by less [sr] are the whole sphere.
constexpr double of_sphere = 1e-6;

/// The faces of a cell that the point lies on, by their inward normals.
TangentCone::Part cone_of_cell(const TetrahedralMesh& mesh, const CellPoint& at, double tolerance) {
  TangentCone::Part normals;
  for (std::size_t i = 0; i < 4; ++i) {
    const FaceIndex face(mesh.faces(at.cell)[i]);
    const double height = 3 * mesh.volume(at.cell) / mesh.area(face);
    if (at.barycentric[i] * height > tolerance) continue;
    const double sign = mesh.owner(face) == at.cell ? -1 : 1;
    normals.push_back(sign * mesh.area_normal(face).normalized());
  }
  return normals;
}

/// Angle inside of a wedge between two planes.
double dihedral_angle(const Vec3& a, const Vec3& b) {
  return pi - std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

/// Of a half space, a wedge or a corner of three planes (Girard 1629).
double solid_angle_of(const TangentCone::Part& normals) {
  if (normals.empty()) return 4 * pi;
  if (normals.size() == 1) return 2 * pi;
  if (normals.size() == 2) return 2 * dihedral_angle(normals[0], normals[1]);
  return dihedral_angle(normals[0], normals[1]) + dihedral_angle(normals[1], normals[2]) +
         dihedral_angle(normals[2], normals[0]) - pi;
}

bool holds(const TangentCone::Part& normals, const Vec3& direction) {
  return std::ranges::all_of(normals, [&](const Vec3& normal) { return normal.dot(direction) >= 0; });
}

}  // namespace

TangentCone::TangentCone(const TetrahedralMesh& mesh, const std::vector<CellPoint>& cells) : solid_angle_(0) {
  if (cells.empty()) throw std::invalid_argument("a tangent cone needs the cells about its point");
  const double tolerance = on_face * bounding_box(mesh.points()).diagonal();
  for (const CellPoint& at : cells) {
    parts_.push_back(cone_of_cell(mesh, at, tolerance));
    solid_angle_ += solid_angle_of(parts_.back());
  }
  if (solid_angle_ < 4 * pi - of_sphere) return;
  parts_.clear();
  solid_angle_ = 4 * pi;
}

bool TangentCone::contains(const Vec3& direction) const {
  return is_whole() || std::ranges::any_of(parts_, [&](const Part& part) { return holds(part, direction); });
}

}  // namespace etendue
