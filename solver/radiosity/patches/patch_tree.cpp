// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/patches/patch_tree.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace etendue {
namespace {

// Of the largest mean square, what is no extent in which a slope could be told.
constexpr double thin = 1e-3;

using Place = Eigen::Matrix<double, 6, 1>;

SurfaceSample joined_samples(const SurfaceSample& a, const SurfaceSample& b) {
  const double area = a.area + b.area;
  return {(a.area * a.position + b.area * b.position) / area, a.area_normal + b.area_normal, area};
}

/// At most as many as a node has: neighbours in the list are joined.
std::vector<SurfaceSample> few(std::vector<SurfaceSample> samples) {
  while (samples.size() > most_samples) {
    std::vector<SurfaceSample> half;
    for (std::size_t i = 0; i + 1 < samples.size(); i += 2)
      half.push_back(joined_samples(samples[i], samples[i + 1]));
    if (samples.size() % 2 != 0) half.push_back(samples.back());
    samples = std::move(half);
  }
  return samples;
}

std::vector<SurfaceSample> samples_of(const FlatPatch& patch) {
  std::vector<SurfaceSample> samples;
  for (const SurfacePoint& point : patch.points())
    samples.push_back({point.position, point.area * patch.normal(), point.area});
  return few(std::move(samples));
}

Eigen::Matrix3d inverse_inertia(const PatchNode& node) {
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(node.sample_count); ++i) {
    const Vec3 separation = node.samples[i].position - node.center;
    inertia += node.samples[i].area / node.area * separation * separation.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
  Vec3 inverse = Vec3::Zero();
  for (Eigen::Index i = 0; i < 3; ++i)
    if (axes.eigenvalues()[i] > thin * axes.eigenvalues()[2]) inverse[i] = 1 / axes.eigenvalues()[i];
  return axes.eigenvectors() * inverse.asDiagonal() * axes.eigenvectors().transpose();
}

}  // namespace

PatchTree::PatchTree(const std::vector<FlatPatch>& patches) : patches_(patches), order_(patches.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  Eigen::AlignedBox3d box;
  for (const FlatPatch& patch : patches) box.extend(patch.centroid());
  normal_weight_ = box.diagonal().norm();
  nodes_.reserve(2 * patches.size());
  nodes_.push_back({.first = 0, .count = static_cast<std::int32_t>(patches.size())});
  for (std::size_t n = 0; n < nodes_.size(); ++n) split(n);
  for (std::size_t n = nodes_.size(); n-- > 0;) measure(nodes_[n]);
  area_before_.push_back(0);
  for (const std::int32_t p : order_)
    area_before_.push_back(area_before_.back() + patches[static_cast<std::size_t>(p)].area());
}

// At the middle of the longest side of the box of places and normals; where they are all one, by number.
void PatchTree::split(std::size_t n) {
  const std::int32_t first = nodes_[n].first, count = nodes_[n].count;
  if (count < 2) return;
  const auto place_of = [&](std::int32_t p) {
    const FlatPatch& patch = patches_[static_cast<std::size_t>(p)];
    Place place;
    place << patch.centroid(), normal_weight_ * patch.normal();
    return place;
  };
  Eigen::AlignedBox<double, 6> box;
  const auto begin = order_.begin() + first, end = begin + count;
  std::for_each(begin, end, [&](std::int32_t p) { box.extend(place_of(p)); });
  Eigen::Index side = 0;
  box.sizes().maxCoeff(&side);
  const double middle = box.center()[side];
  auto second = std::stable_partition(begin, end, [&](std::int32_t p) { return place_of(p)[side] < middle; });
  if (second == begin || second == end) second = begin + count / 2;
  const auto left = static_cast<std::int32_t>(second - begin);
  nodes_[n].children = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({.first = first, .count = left});
  nodes_.push_back({.first = first + left, .count = count - left});
}

void PatchTree::measure(PatchNode& node) const {
  for (const std::int32_t p : patches_of(node)) {
    const FlatPatch& patch = patches_[static_cast<std::size_t>(p)];
    node.area += patch.area();
    node.center += patch.area() * patch.centroid();
    node.axis += patch.area() * patch.normal();
  }
  node.center /= node.area;
  node.axis.normalize();
  for (const std::int32_t p : patches_of(node)) {
    const FlatPatch& patch = patches_[static_cast<std::size_t>(p)];
    node.spread = std::max(node.spread, (patch.normal() - node.axis).norm());
    for (const TriangleCorners& triangle : patch.triangles())
      for (const Vec3& corner : triangle) {
        node.radius = std::max(node.radius, (corner - node.center).norm());
        node.thickness = std::max(node.thickness, std::abs((corner - node.center).dot(node.axis)));
      }
  }
  std::vector<SurfaceSample> samples;
  if (node.is_patch()) {
    samples = samples_of(patches_[static_cast<std::size_t>(patches_of(node)[0])]);
  } else {
    for (const std::int32_t child : {node.children, node.children + 1}) {
      const PatchNode& part = nodes_[static_cast<std::size_t>(child)];
      samples.insert(samples.end(), part.samples.begin(), part.samples.begin() + part.sample_count);
    }
    samples = few(std::move(samples));
  }
  node.sample_count = static_cast<std::int32_t>(samples.size());
  std::ranges::copy(samples, node.samples.begin());
  node.inverse_inertia = inverse_inertia(node);
}

SurfaceSite PatchTree::site_of(const PatchNode& node, double t, double u, double v) const {
  const auto begin = area_before_.begin() + node.first;
  const double sought = *begin + t * node.area;
  const auto above = std::upper_bound(begin + 1, begin + node.count, sought);
  const auto place = static_cast<std::size_t>(above - area_before_.begin()) - 1;
  const FlatPatch& patch = patches_[static_cast<std::size_t>(order_[place])];
  return {patch.point_at(u, v), patch.normal()};
}

}  // namespace etendue
