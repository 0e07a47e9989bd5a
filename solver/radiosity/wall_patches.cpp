// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/wall_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace etendue {
namespace {

// Sine between normals, and distance relative to the size of the domain, of faces in one plane.
constexpr double in_plane = 1e-9;

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

/// Numbers planes: faces in the same one, to rounding, have the same number.
class Planes {
 public:
  explicit Planes(double size) : size_(size) {}

  std::size_t number_of(const TriangleCorners& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    const double offset = normal.dot(t[0]);
    const auto same = [&](const Plane& plane) {
      return normal.cross(plane.normal).norm() < in_plane && normal.dot(plane.normal) > 0 &&
             std::abs(offset - plane.offset) < in_plane * size_;
    };
    // Neighbours in the list are mostly neighbours in space.
    if (last_ < planes_.size() && same(planes_[last_])) return last_;
    last_ = static_cast<std::size_t>(std::ranges::find_if(planes_, same) - planes_.begin());
    if (last_ == planes_.size()) planes_.push_back({normal, offset});
    return last_;
  }

 private:
  struct Plane {
    Vec3 normal;
    double offset;
  };
  double size_;
  std::vector<Plane> planes_;
  std::size_t last_ = 0;
};

/// The square of a grid in the plane of a triangle that its centre lies in.
std::array<long, 2> square_of(const TriangleCorners& t, double size) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  Eigen::Index across = 0;
  normal.cwiseAbs().maxCoeff(&across);
  const Vec3 u = Vec3::Unit((across + 1) % 3).cross(normal).normalized(), v = normal.cross(u);
  const Vec3 center = (t[0] + t[1] + t[2]) / 3;
  return {std::lround(std::floor(center.dot(u) / size)), std::lround(std::floor(center.dot(v) / size))};
}

double domain_size(const TetrahedralMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.points()) box.extend(point);
  return box.diagonal().norm();
}

}  // namespace

WallPatches wall_patches(const TetrahedralMesh& mesh, double size) {
  WallPatches result;
  std::vector<std::vector<TriangleCorners>> triangles;  // [patch]
  std::map<std::tuple<int, std::size_t, long, long>, std::size_t> joined;
  Planes planes(domain_size(mesh));
  const auto add = [&](int wall) {
    triangles.emplace_back();
    result.walls.push_back(wall);
    return triangles.size() - 1;
  };
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const TriangleCorners whole = inward_triangle(mesh, face);
    const int wall = mesh.wall(face);
    std::vector<FacePart>& parts = result.of_faces.emplace_back();
    if (size > 0 && longest_side(whole) > size) {
      std::vector<TriangleCorners> quarters;
      append_quarters(whole, size, quarters);
      for (const TriangleCorners& quarter : quarters) {
        parts.push_back({add(wall), 1.0 / static_cast<double>(quarters.size())});
        triangles.back().push_back(quarter);
      }
      continue;
    }
    std::size_t patch = 0;
    if (size > 0) {
      const auto [i, j] = square_of(whole, size);
      const auto [place, is_new] = joined.try_emplace({wall, planes.number_of(whole), i, j}, 0);
      patch = place->second = is_new ? add(wall) : place->second;
    } else {
      patch = add(wall);
    }
    triangles[patch].push_back(whole);
    parts.push_back({patch, 1});
  }
  for (std::vector<TriangleCorners>& patch : triangles) result.patches.emplace_back(std::move(patch));
  return result;
}

std::vector<TriangleCorners> triangles_of(const std::vector<FlatPatch>& patches) {
  std::vector<TriangleCorners> triangles;
  for (const FlatPatch& patch : patches)
    triangles.insert(triangles.end(), patch.triangles().begin(), patch.triangles().end());
  return triangles;
}

}  // namespace etendue
