// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/emitter_tree.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "base/quadrature/simplex_rules.h"
#include "solver/uncollided/closed_form/closest_point.h"
#include "solver/uncollided/closed_form/triangle.h"

namespace etendue {
namespace {

/// A group whose points lie farther beside it than this part of its radius is sampled in parts.
constexpr double beside = 0.1;

std::size_t corner_count(EmitterShape shape) { return shape == EmitterShape::triangles ? 3 : 4; }

Vec3 area_normal(const EmitterPart& part) {
  return (part.corners[1] - part.corners[0]).cross(part.corners[2] - part.corners[0]) / 2;
}

double measure(const EmitterPart& part, EmitterShape shape) {
  if (shape == EmitterShape::triangles) return area_normal(part).norm();
  const Vec3 a = part.corners[1] - part.corners[0], b = part.corners[2] - part.corners[0],
             c = part.corners[3] - part.corners[0];
  return std::abs(a.cross(b).dot(c)) / 6;
}

}  // namespace

/// Moments of the brightness, added up over the bands.
struct EmitterTree::Moments {
  double zeroth = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  std::vector<double> total;
  Vec3 normal = Vec3::Zero();

  void add(const Moments& other) {
    zeroth += other.zeroth;
    first += other.first;
    second += other.second;
    for (std::size_t b = 0; b < total.size(); ++b) total[b] += other.total[b];
    if ((normal - other.normal).norm() > one_plane) normal.setZero();
  }
};

EmitterTree::EmitterTree(EmitterShape shape, std::vector<EmitterPart> parts)
    : shape_(shape), parts_(std::move(parts)) {
  std::vector<int> members(parts_.size());
  std::iota(members.begin(), members.end(), 0);
  nodes_.reserve(2 * parts_.size());
  nodes_.emplace_back();
  build(0, members);
  for (const EmitterPart& part : parts_)
    for (std::size_t i = 0; i < corner_count(shape_); ++i) box_.extend(part.corners[i]);
}

// The integral of (x - c)(x - c)^T over a simplex of dimension d with corners v and centroid c is its measure
// / ((d + 1)(d + 2)) times the sum of (v - c)(v - c)^T.
EmitterTree::Moments EmitterTree::moments_of(const EmitterPart& part) const {
  const std::size_t corners = corner_count(shape_);
  Moments moments;
  moments.total = part.brightness;
  for (double& value : moments.total) value *= measure(part, shape_);
  moments.zeroth = std::accumulate(moments.total.begin(), moments.total.end(), 0.0);
  Vec3 centre = Vec3::Zero();
  for (std::size_t i = 0; i < corners; ++i) centre += part.corners[i] / static_cast<double>(corners);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < corners; ++i)
    spread += (part.corners[i] - centre) * (part.corners[i] - centre).transpose();
  moments.first = moments.zeroth * centre;
  moments.second =
      moments.zeroth * (spread / static_cast<double>(corners * (corners + 1)) + centre * centre.transpose());
  if (shape_ == EmitterShape::triangles) moments.normal = area_normal(part).normalized();
  return moments;
}

EmitterTree::Moments EmitterTree::build(int node, std::span<int> members) {
  Moments moments;
  if (members.size() == 1) {
    moments = moments_of(parts_[static_cast<std::size_t>(members[0])]);
    nodes_[static_cast<std::size_t>(node)].part = members[0];
  } else {
    Eigen::AlignedBox3d box;
    const auto centre = [&](int i) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t k = 0; k < corner_count(shape_); ++k)
        sum += parts_[static_cast<std::size_t>(i)].corners[k];
      return sum;
    };
    for (const int i : members) box.extend(centre(i));
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto middle = members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2);
    std::nth_element(members.begin(), middle, members.end(), [&](int i, int j) {
      return std::pair(centre(i)[axis], i) < std::pair(centre(j)[axis], j);
    });
    const int left = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    nodes_.emplace_back();
    nodes_[static_cast<std::size_t>(node)].children = {left, left + 1};
    moments = build(left, members.first(members.size() / 2));
    moments.add(build(left + 1, members.subspan(members.size() / 2)));
  }
  finish(nodes_[static_cast<std::size_t>(node)], moments, members);
  return moments;
}

void EmitterTree::finish(Node& node, const Moments& moments, std::span<const int> members) const {
  node.total = moments.total;
  node.normal = moments.normal;
  node.centre = moments.first / moments.zeroth;
  for (const int i : members)
    for (std::size_t k = 0; k < corner_count(shape_); ++k)
      node.radius =
          std::max(node.radius, (parts_[static_cast<std::size_t>(i)].corners[k] - node.centre).norm());
  for (const int i : members)
    for (const double extinction : parts_[static_cast<std::size_t>(i)].extinction)
      node.thickness = std::max(node.thickness, extinction * node.radius);
  node.middle = closest(node.centre, members);
  if (node.part < 0) return place_points(node, moments, members);
  const auto& corners = parts_[static_cast<std::size_t>(node.part)].corners;
  if (shape_ == EmitterShape::triangles)
    for (const FacePointWeight& point : three_point_rule())
      node.points[node.point_count++] = point.barycentric[0] * corners[0] +
                                        point.barycentric[1] * corners[1] + point.barycentric[2] * corners[2];
  else
    for (const CellPointWeight& point : four_point_rule())
      node.points[node.point_count++] = point.barycentric[0] * corners[0] +
                                        point.barycentric[1] * corners[1] +
                                        point.barycentric[2] * corners[2] + point.barycentric[3] * corners[3];
}

// One standard deviation to both sides: for a box these are the points of Gauss, two along each side. In a
// plane along the principal axes; in space along x, y and z, where most bodies have their sides. A point
// beside the light is moved into it: from there rays could start outside of the domain.
void EmitterTree::place_points(Node& node, const Moments& moments, std::span<const int> members) const {
  const Eigen::Matrix3d covariance = moments.second / moments.zeroth - node.centre * node.centre.transpose();
  std::vector<Vec3> steps;
  if (shape_ == EmitterShape::tetrahedra) {
    for (int k = 0; k < 3; ++k)
      steps.emplace_back(std::sqrt(std::max(0.0, covariance(k, k))) * Vec3::Unit(k));
  } else {
    // Rising: across the plane it is zero.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
    for (int k = 1; k < 3; ++k)
      steps.emplace_back(std::sqrt(std::max(0.0, axes.eigenvalues()[k])) * axes.eigenvectors().col(k));
  }
  node.point_count = std::size_t{1} << steps.size();
  for (std::size_t i = 0; i < node.point_count; ++i) {
    node.points[i] = node.centre;
    for (std::size_t k = 0; k < steps.size(); ++k)
      node.points[i] += (i >> k & 1) != 0 ? steps[k] : Vec3(-steps[k]);
    const Vec3 inside = closest(node.points[i], members);
    node.hollow = node.hollow || (inside - node.points[i]).norm() > beside * node.radius;
    node.points[i] = inside;
  }
}

Vec3 EmitterTree::closest(const Vec3& point, std::span<const int> members) const {
  Vec3 best = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (const int i : members) {
    const auto& c = parts_[static_cast<std::size_t>(i)].corners;
    const Vec3 here = shape_ == EmitterShape::triangles ? closest_in_triangle(point, {c[0], c[1], c[2]})
                                                        : closest_in_tetrahedron(point, c);
    if ((here - point).squaredNorm() < (best - point).squaredNorm()) best = here;
  }
  return best;
}

}  // namespace etendue
