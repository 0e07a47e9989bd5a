// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/rays/medium_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "mesh/tetrahedra/bounding_box.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/uncollided/closed_form/convex_parts.h"

namespace etendue {
namespace {

/// Of the size of the domain: what is nearer to a point touches it. Far from the origin of the coordinates
/// their rounding counts, in roundings of the largest one.
constexpr double touching_of_size = 1e-9, touching_roundings = 64;
/// Of the size: corners that differ less from a plane lie in it. A path that meets a plane at a smaller
/// cosine than the other number would leave such corners beside it by more than what touches.
constexpr double in_plane = 1e-13, along_plane = 1e-4;
/// Planes of the boundary up to which its convex parts are looked for.
constexpr std::size_t most_planes_of_hull = 100;

bool are_parallel(const Vec3& normal, const Vec3& other) {
  constexpr double rounding = 1e-12;
  return (normal - other).norm() < rounding;
}

/// Planes that have all of a mesh on one side.
class Hull {
 public:
  Hull(const TetrahedralMesh& mesh, double touching) : mesh_(mesh), touching_(touching) {}

  bool has(FaceIndex face) {
    const Vec3 normal = mesh_.area_normal(face).normalized();
    const double height = normal.dot(mesh_.centroid(face));
    for (const Plane& plane : planes_)
      if (are_parallel(plane.normal, normal) && std::abs(plane.height - height) < touching_)
        return plane.outside;
    if (planes_.size() == most_planes_of_hull) return false;
    const bool outside = std::ranges::all_of(
        mesh_.points(), [&](const Vec3& point) { return normal.dot(point) <= height + touching_; });
    planes_.push_back({normal, height, outside});
    return outside;
  }

 private:
  struct Plane {
    Vec3 normal;
    double height;
    bool outside;
  };
  const TetrahedralMesh& mesh_;
  double touching_;
  std::vector<Plane> planes_;
};

double touching_distance(const TetrahedralMesh& mesh) {
  const BoundingBox box = bounding_box(mesh.points());
  const double largest = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  return std::max(touching_of_size * box.diagonal(),
                  touching_roundings * std::numeric_limits<double>::epsilon() * largest);
}

/// A surface that rays know, once; flat pieces have the same media, or the same wall, on all of their faces.
struct SurfaceFace {
  FaceIndex face;
  Vec3 normal;
  std::array<std::int32_t, 3> kind;  ///< its wall, or the medium before it and that behind it
  bool merges;  ///< with others in its plane: a path that crosses it needs no cell behind it
};

std::vector<SurfaceFace> surfaces_of(const TetrahedralMesh& mesh, std::span<const std::int32_t> medium,
                                     bool whole_boundary, double touching) {
  constexpr std::int32_t none = -2;
  std::vector<SurfaceFace> faces;
  Hull hull(mesh, touching);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const FaceIndex face(f);
    const Vec3 normal = mesh.area_normal(face).normalized();
    if (f < mesh.boundary_face_count()) {
      if (whole_boundary || !hull.has(face))
        faces.push_back({face, normal, {mesh.wall(face), none, none}, true});
      continue;
    }
    const std::int32_t before = medium[mesh.owner(face).at()];
    const std::int32_t behind = medium[mesh.neighbour(face).at()];
    if (before == behind) continue;
    const bool merges = before != MediumSurfaces::varying && behind != MediumSurfaces::varying;
    if (before < behind)
      faces.push_back({face, normal, {none, before, behind}, merges});
    else
      faces.push_back({face, -normal, {none, behind, before}, merges});
  }
  return faces;
}

/// Faces that share edges and lie in one plane, with the same on both sides.
class FlatPieces {
 public:
  FlatPieces(const TetrahedralMesh& mesh, std::span<const SurfaceFace> faces)
      : mesh_(mesh), faces_(faces), size_(bounding_box(mesh.points()).diagonal()), root_(faces.size()) {
    std::iota(root_.begin(), root_.end(), 0);
    join_at_edges();
  }

  /// Few convex polygons for each piece, or its faces one by one.
  std::vector<FaceTree::Polygon> polygons() {
    std::map<std::size_t, std::vector<std::size_t>> pieces;
    for (std::size_t i = 0; i < faces_.size(); ++i) pieces[root(i)].push_back(i);
    std::vector<FaceTree::Polygon> polygons;
    for (const auto& [first, members] : pieces) add(members, polygons);
    return polygons;
  }

 private:
  struct Edge {
    std::array<std::int32_t, 2> ends;
    std::size_t face;
  };

  std::size_t root(std::size_t i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void join_at_edges() {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (!faces_[i].merges) continue;
      const auto& v = mesh_.vertices(faces_[i].face);
      for (const std::array<std::int32_t, 2> ends : {std::array{v[0], v[1]}, {v[0], v[2]}, {v[1], v[2]}})
        edges.push_back({ends, i});
    }
    std::ranges::stable_sort(edges, {}, &Edge::ends);
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = i + 1; j < edges.size() && edges[j].ends == edges[i].ends; ++j)
        if (are_alike(edges[i].face, edges[j].face)) join(edges[i].face, edges[j].face);
  }
  bool are_alike(std::size_t a, std::size_t b) const {
    return faces_[a].kind == faces_[b].kind && are_parallel(faces_[a].normal, faces_[b].normal);
  }
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    root_[std::max(a, b)] = std::min(a, b);
  }
  std::array<Vec3, 3> corners_about_normal(std::size_t i) const {
    std::array<Vec3, 3> corners = corners_of(mesh_, faces_[i].face);
    if ((corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(faces_[i].normal) < 0)
      std::swap(corners[1], corners[2]);
    return corners;
  }
  bool lie_in_plane_of(const SurfaceFace& first, std::span<const std::size_t> members) const {
    const Vec3& corner = corner_of(mesh_, first.face, 0);
    for (const std::size_t i : members)
      for (const Vec3& other : corners_of(mesh_, faces_[i].face))
        if (std::abs(first.normal.dot(other - corner)) > in_plane * size_) return false;
    return true;
  }
  void add(std::span<const std::size_t> members, std::vector<FaceTree::Polygon>& polygons) const {
    const SurfaceFace& first = faces_[members.front()];
    if (members.size() > 1 && lie_in_plane_of(first, members)) {
      std::vector<std::array<Vec3, 3>> triangles;
      for (const std::size_t i : members) triangles.push_back(corners_about_normal(i));
      const auto parts = convex_parts(triangles, first.normal);
      for (const std::vector<Vec3>& corners : parts)
        polygons.push_back({first.face.value(), false, first.normal, corners});
      if (!parts.empty()) return;
    }
    for (const std::size_t i : members) polygons.push_back(FaceTree::polygon_of(mesh_, faces_[i].face));
  }

  const TetrahedralMesh& mesh_;
  std::span<const SurfaceFace> faces_;
  double size_;
  std::vector<std::size_t> root_;
};

std::vector<FaceTree::Polygon> polygons_of(const TetrahedralMesh& mesh, std::span<const std::int32_t> medium,
                                           bool whole_boundary, double touching) {
  if (std::ranges::count(medium, MediumSurfaces::varying) == std::ssize(medium)) return {};
  const std::vector<SurfaceFace> faces = surfaces_of(mesh, medium, whole_boundary, touching);
  return FlatPieces(mesh, faces).polygons();
}

}  // namespace

MediumSurfaces::MediumSurfaces(const TetrahedralMesh& mesh, std::vector<std::int32_t> medium,
                               bool whole_boundary)
    : mesh_(mesh),
      medium_(std::move(medium)),
      touching_(touching_distance(mesh)),
      faces_(polygons_of(mesh, medium_, whole_boundary, touching_), touching_) {
  // Where media change every few cells, cells are the shorter way.
  constexpr std::size_t fewest_cells_on_a_polygon = 4;
  if (faces_.size() * fewest_cells_on_a_polygon > medium_.size()) std::ranges::fill(medium_, varying);
}

// A path within the domain meets its boundary from within alone. What touches the surface where it ends has
// not met it.
MediumSurfaces::Crossing MediumSurfaces::first(const Vec3& from, const Vec3& direction, double length,
                                               std::int32_t medium, std::optional<FaceIndex> through) const {
  Crossing found{.distance = length};
  const double end = length - touching_;
  double unclear = std::numeric_limits<double>::infinity(), limit = end;
  const TreeRay ray = faces_.ray(from, direction);
  faces_.visit(ray, limit, [&](const FaceTree::Flat& flat) {
    const FaceIndex face(flat.face);
    if (through == face) return;
    const double cosine = direction.dot(flat.normal);
    if (cosine <= 0 && flat.face < mesh_.boundary_face_count()) return;
    const double height = flat.height_of(ray.origin);
    if (!(std::abs(cosine) > along_plane)) {
      if (std::abs(height) <= touching_ + std::abs(cosine) * limit) unclear = 0;
      return;
    }
    const double distance = -height / cosine;
    if (distance < -touching_ || distance > limit) return;
    const double inside = flat.inside(ray.origin + distance * direction);
    if (inside < -touching_) return;
    const bool again =
        found.kind == Crossing::Kind::surface && std::abs(distance - found.distance) < touching_;
    if (inside < touching_ || distance < touching_ || again) {
      unclear = std::min(unclear, distance);
    } else if (distance < found.distance) {
      found = {Crossing::Kind::surface, distance, face, flat.single};
      limit = std::min(end, distance + touching_);
    }
  });
  // All of an interface has the same media on its sides, a wall may have others elsewhere.
  const bool known = found.exact || found.face.value() >= mesh_.boundary_face_count();
  const bool wrong = found.kind == Crossing::Kind::surface && known &&
                     medium_[beyond(found.face, -direction).at()] != medium;
  if (unclear < found.distance + touching_ || wrong) found.kind = Crossing::Kind::unclear;
  return found;
}

}  // namespace etendue
