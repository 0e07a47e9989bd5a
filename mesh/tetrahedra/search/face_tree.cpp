// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/face_tree.h"

#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

constexpr std::size_t polygons_in_a_leaf = 4;

}  // namespace

FaceTree::Polygon FaceTree::polygon_of(const TetrahedralMesh& mesh, FaceIndex face) {
  const std::array<Vec3, 3> corners = corners_of(mesh, face);
  return {face.value(), true, mesh.area_normal(face).normalized(), {corners.begin(), corners.end()}};
}

FaceTree::FaceTree(std::vector<Polygon> polygons, double margin) {
  Eigen::AlignedBox3d whole;
  std::size_t corners = 0;
  for (const Polygon& polygon : polygons) {
    for (const Vec3& corner : polygon.corners) whole.extend(corner);
    corners += polygon.corners.size();
  }
  if (!polygons.empty()) middle_ = whole.center();
  std::vector<Bounds> bounds;
  for (Polygon& polygon : polygons) {
    bounds.push_back({{}, bounds.size()});
    for (Vec3& corner : polygon.corners) bounds.back().box.extend(corner -= middle_);
  }
  nodes_.emplace_back();
  build(0, bounds, 0, margin);
  sides_.reserve(corners);
  for (const Bounds& of : bounds) add(polygons[of.polygon]);
}

void FaceTree::add(const Polygon& polygon) {
  const std::size_t first = sides_.size(), count = polygon.corners.size();
  Vec3 inside = Vec3::Zero();
  for (const Vec3& corner : polygon.corners) inside += corner / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 &here = polygon.corners[i], &next = polygon.corners[(i + 1) % count];
    Vec3 inwards = polygon.normal.cross(next - here).normalized();
    if (inwards.dot(inside - here) < 0) inwards = -inwards;
    sides_.push_back({inwards, inwards.dot(here)});
  }
  flats_.push_back({polygon.face, polygon.single, polygon.normal, polygon.normal.dot(polygon.corners[0]),
                    std::span(sides_).subspan(first)});
}

void FaceTree::build(std::size_t node, std::span<Bounds> bounds, std::size_t first, double margin) {
  Eigen::AlignedBox3d box, middles;
  for (const Bounds& of : bounds) {
    middles.extend(of.box.center());
    box.extend(of.box);
  }
  const Vec3 low = box.min() - Vec3::Constant(margin), high = box.max() + Vec3::Constant(margin);
  nodes_[node] = {.box = {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()},
                  .first = static_cast<std::int32_t>(first),
                  .count = static_cast<std::int32_t>(bounds.size())};
  if (bounds.size() <= polygons_in_a_leaf) return;
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::size_t half = bounds.size() / 2;
  std::nth_element(bounds.begin(), bounds.begin() + static_cast<std::ptrdiff_t>(half), bounds.end(),
                   [axis](const Bounds& a, const Bounds& b) {
                     const double of_a = a.box.center()[axis], of_b = b.box.center()[axis];
                     return of_a != of_b ? of_a < of_b : a.polygon < b.polygon;
                   });
  const std::size_t children = nodes_.size();
  nodes_[node].children = static_cast<std::int32_t>(children);
  nodes_.resize(children + 2);
  build(children, bounds.first(half), first, margin);
  build(children + 1, bounds.subspan(half), first + half, margin);
}

}  // namespace etendue
