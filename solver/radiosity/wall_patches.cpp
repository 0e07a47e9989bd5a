// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/wall_patches.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/tetrahedra/flat_neighbours.h"

namespace etendue {
namespace {

TriangleCorners inward_triangle(const TetrahedralMesh& mesh, FaceIndex face) {
  TriangleCorners t;
  for (std::size_t i = 0; i < 3; ++i) t[i] = mesh.point(VertexIndex(mesh.vertices(face)[i]));
  if ((t[1] - t[0]).cross(t[2] - t[0]).dot(mesh.area_normal(face)) > 0) std::swap(t[1], t[2]);
  return t;
}

double longest_side(const TriangleCorners& t) {
  return std::sqrt(
      std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()}));
}

void append_quarters(const TriangleCorners& t, double size, std::vector<TriangleCorners>& parts) {
  if (longest_side(t) <= size) {
    parts.push_back(t);
    return;
  }
  const Vec3 ab = (t[0] + t[1]) / 2, bc = (t[1] + t[2]) / 2, ca = (t[2] + t[0]) / 2;
  append_quarters({t[0], ab, ca}, size, parts);
  append_quarters({ab, t[1], bc}, size, parts);
  append_quarters({ca, bc, t[2]}, size, parts);
  append_quarters({ab, bc, ca}, size, parts);
}

/// The square of a grid in the plane of a triangle that its centre lies in.
std::array<long, 2> square_of(const TriangleCorners& t, double size) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  Eigen::Index across = 0;
  normal.cwiseAbs().maxCoeff(&across);
  const Vec3 u = Vec3::Unit((across + 1) % 3).cross(normal).normalized(), v = normal.cross(u);
  const Vec3 center = (t[0] + t[1] + t[2]) / 3;
  return {std::lround(std::floor(center.dot(u) / size)), std::lround(std::floor(center.dot(v) / size))};
}

/// Joins the faces that are small enough: from each one on, those beyond its edges.
class JoinedFaces {
 public:
  JoinedFaces(const TetrahedralMesh& mesh, double size)
      : mesh_(mesh), size_(size), beyond_(flat_neighbours(mesh)), taken_(beyond_.size()) {}

  /// The faces of the patch that a face lies in; empty where it has been given already.
  std::vector<std::int32_t> take(std::int32_t face) {
    if (taken_[static_cast<std::size_t>(face)]) return {};
    taken_[static_cast<std::size_t>(face)] = true;
    std::vector<std::int32_t> patch = {face};
    const auto square = square_of(inward_triangle(mesh_, FaceIndex(face)), size_);
    for (std::size_t i = 0; i < patch.size(); ++i)
      for (const std::int32_t next : beyond_[static_cast<std::size_t>(patch[i])]) {
        if (next < 0 || taken_[static_cast<std::size_t>(next)]) continue;
        const TriangleCorners triangle = inward_triangle(mesh_, FaceIndex(next));
        if (mesh_.wall(FaceIndex(next)) != mesh_.wall(FaceIndex(face)) || longest_side(triangle) > size_ ||
            square_of(triangle, size_) != square)
          continue;
        taken_[static_cast<std::size_t>(next)] = true;
        patch.push_back(next);
      }
    return patch;
  }

 private:
  const TetrahedralMesh& mesh_;
  double size_;
  std::vector<std::array<std::int32_t, 3>> beyond_;
  std::vector<bool> taken_;
};

}  // namespace

WallPatches wall_patches(const TetrahedralMesh& mesh, double size) {
  WallPatches result;
  result.of_faces.resize(static_cast<std::size_t>(mesh.boundary_face_count()));
  const auto add = [&](FaceIndex face, std::vector<TriangleCorners> triangles) {
    result.patches.emplace_back(std::move(triangles));
    result.walls.push_back(mesh.wall(face));
    return result.patches.size() - 1;
  };
  JoinedFaces joined(mesh, size);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const TriangleCorners whole = inward_triangle(mesh, face);
    std::vector<TriangleCorners> quarters;
    if (size > 0) append_quarters(whole, size, quarters);
    if (quarters.size() > 1) {
      for (const TriangleCorners& quarter : quarters)
        result.of_faces[face.at()].push_back(
            {add(face, {quarter}), 1.0 / static_cast<double>(quarters.size())});
    } else if (size > 0) {
      std::vector<TriangleCorners> triangles;
      const std::vector<std::int32_t> faces = joined.take(f);
      for (const std::int32_t each : faces) triangles.push_back(inward_triangle(mesh, FaceIndex(each)));
      for (const std::int32_t each : faces)
        result.of_faces[static_cast<std::size_t>(each)].push_back({result.patches.size(), 1});
      if (!faces.empty()) add(face, std::move(triangles));
    } else {
      result.of_faces[face.at()].push_back({add(face, {whole}), 1});
    }
  }
  return result;
}

std::vector<TriangleCorners> triangles_of(const std::vector<FlatPatch>& patches) {
  std::vector<TriangleCorners> triangles;
  for (const FlatPatch& patch : patches)
    triangles.insert(triangles.end(), patch.triangles().begin(), patch.triangles().end());
  return triangles;
}

}  // namespace etendue
