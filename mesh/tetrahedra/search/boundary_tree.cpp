// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/boundary_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace etendue {
namespace {

constexpr std::int32_t faces_in_a_leaf = 4;
// A ray that meets the edge of two faces must not slip between them.
constexpr double edge_tolerance = 1e-12;

struct Ray {
  Vec3 origin;
  Vec3 direction;
  Vec3 inverse;
};

/// Whether the ray meets the box before this distance.
bool meets(const Eigen::AlignedBox3d& box, const Ray& ray, double limit) {
  double in = 0, out = limit;
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (ray.direction[k] == 0) {
      if (ray.origin[k] < box.min()[k] || ray.origin[k] > box.max()[k]) return false;
      continue;
    }
    const double a = (box.min()[k] - ray.origin[k]) * ray.inverse[k];
    const double b = (box.max()[k] - ray.origin[k]) * ray.inverse[k];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  // A flat box is met where in and out agree to rounding.
  return in <= out * (1 + edge_tolerance) + std::numeric_limits<double>::min();
}

/// Distance to a face (Möller and Trumbore 1997); not a number where the ray passes beside it.
double distance_to(const TetrahedralMesh& mesh, FaceIndex face, const Ray& ray) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto& corners = mesh.vertices(face);
  const Vec3& a = mesh.point(VertexIndex(corners[0]));
  const Vec3 ab = mesh.point(VertexIndex(corners[1])) - a, ac = mesh.point(VertexIndex(corners[2])) - a;
  const Vec3 across = ray.direction.cross(ac);
  const double det = ab.dot(across);
  if (det == 0) return none;
  const Vec3 to = ray.origin - a;
  const double u = to.dot(across) / det;
  const Vec3 other = to.cross(ab);
  const double v = ray.direction.dot(other) / det;
  if (u < -edge_tolerance || v < -edge_tolerance || u + v > 1 + edge_tolerance) return none;
  return ac.dot(other) / det;
}

}  // namespace

BoundaryTree::BoundaryTree(const TetrahedralMesh& mesh) : mesh_(mesh) {
  faces_.resize(static_cast<std::size_t>(mesh.boundary_face_count()));
  std::iota(faces_.begin(), faces_.end(), 0);
  std::vector<Vec3> centroids;
  for (const std::int32_t face : faces_) centroids.push_back(mesh.centroid(FaceIndex(face)));
  build(0, static_cast<std::int32_t>(faces_.size()), centroids);
}

std::int32_t BoundaryTree::build(std::int32_t first, std::int32_t last, std::span<const Vec3> centroids) {
  const auto number = static_cast<std::int32_t>(nodes_.size());
  Node node{.first = first, .last = last};
  Eigen::AlignedBox3d middles;
  for (std::int32_t i = first; i < last; ++i) {
    const std::int32_t face = faces_[static_cast<std::size_t>(i)];
    middles.extend(centroids[static_cast<std::size_t>(face)]);
    for (const std::int32_t v : mesh_.vertices(FaceIndex(face))) node.box.extend(mesh_.point(VertexIndex(v)));
  }
  nodes_.push_back(node);
  if (last - first <= faces_in_a_leaf) return number;
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::int32_t middle = (first + last) / 2;
  std::nth_element(faces_.begin() + first, faces_.begin() + middle, faces_.begin() + last,
                   [&](std::int32_t a, std::int32_t b) {
                     return centroids[static_cast<std::size_t>(a)][axis] <
                            centroids[static_cast<std::size_t>(b)][axis];
                   });
  const std::int32_t left = build(first, middle, centroids), right = build(middle, last, centroids);
  nodes_[static_cast<std::size_t>(number)].children = {left, right};
  return number;
}

std::optional<BoundaryEntry> BoundaryTree::first_entry(const Vec3& origin, const Vec3& direction) const {
  const Ray ray{origin, direction, direction.cwiseInverse()};
  double nearest = std::numeric_limits<double>::infinity();
  std::int32_t found = -1;
  std::array<std::int32_t, 64> waiting{};  // halved at every level: deeper than any mesh has faces
  std::size_t count = 1;
  while (count > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(waiting[--count])];
    if (!meets(node.box, ray, nearest)) continue;
    if (node.children[0] >= 0) {
      for (const std::int32_t child : node.children) waiting[count++] = child;
      continue;
    }
    for (std::int32_t i = node.first; i < node.last; ++i) {
      const FaceIndex face(faces_[static_cast<std::size_t>(i)]);
      if (direction.dot(mesh_.area_normal(face)) >= 0) continue;
      const double distance = distance_to(mesh_, face, ray);
      if (!(distance >= 0 && distance < nearest)) continue;
      nearest = distance;
      found = face.value();
    }
  }
  if (found < 0) return std::nullopt;
  return BoundaryEntry{FaceIndex(found), origin + nearest * direction};
}

}  // namespace etendue
