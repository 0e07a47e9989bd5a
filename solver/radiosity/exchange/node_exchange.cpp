// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange/node_exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace etendue {
namespace {

// Largest |normal - mean normal| of a node that looks to one side: some 30 degrees.
constexpr double one_side = 0.5;
// Height above a plane, relative to the distance to it, that is rounding.
constexpr double node_in_plane = 1e-12;

/// Returns whether all of b is behind all patches of a.
bool is_behind(const PatchNode& a, const PatchNode& b) {
  const Vec3 separation = b.center - a.center;
  const double cosine = a.axis.dot(b.axis), across = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double reach = separation.norm() + a.radius + b.radius;
  // Of b above its centre along the axis of a: it lies in a ball and between two planes across its own axis.
  const double rise = std::min(b.radius, across * b.radius + std::abs(cosine) * b.thickness);
  return a.axis.dot(separation) + a.thickness + rise + a.spread * reach <= node_in_plane * reach;
}

double kernel_between(const SurfaceSample& p, const SurfaceSample& q) {
  const Vec3 separation = q.position - p.position;
  const double r2 = separation.squaredNorm();
  const double leaving = std::max(0.0, p.area_normal.dot(separation)),
               arriving = std::max(0.0, -q.area_normal.dot(separation));
  return leaving * arriving / (std::numbers::pi * r2 * r2 * p.area * q.area);
}

/// Of the values at samples, weighted by areas.
Vec3 slope(const PatchNode& node, const std::array<double, most_samples>& values) {
  Vec3 moment = Vec3::Zero();
  if (node.is_patch()) return moment;
  for (std::size_t i = 0; i < static_cast<std::size_t>(node.sample_count); ++i)
    moment += node.samples[i].area / node.area * values[i] * (node.samples[i].position - node.center);
  return node.inverse_inertia * moment;
}

}  // namespace

// A linear fit on each side: means over the other side, and the regression of these.
NodeKernel node_kernel(const PatchNode& a, const PatchNode& b) {
  const auto of_a = static_cast<std::size_t>(a.sample_count), of_b = static_cast<std::size_t>(b.sample_count);
  std::array<std::array<double, most_samples>, most_samples> value;
  std::array<double, most_samples> mean_a{}, mean_b{};
  NodeKernel kernel;
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (std::size_t i = 0; i < of_a; ++i)
    for (std::size_t k = 0; k < of_b; ++k) {
      const SurfaceSample &p = a.samples[i], &q = b.samples[k];
      value[i][k] = kernel_between(p, q);
      lowest = std::min(lowest, value[i][k]);
      highest = std::max(highest, value[i][k]);
      mean_a[i] += value[i][k] * q.area / b.area;
      mean_b[k] += value[i][k] * p.area / a.area;
    }
  for (std::size_t i = 0; i < of_a; ++i) kernel.mean += mean_a[i] * a.samples[i].area / a.area;
  kernel.variation = (highest - lowest) / 2;
  kernel.slope_a = slope(a, mean_a);
  kernel.slope_b = slope(b, mean_b);
  for (std::size_t i = 0; i < (a.is_patch() ? 1 : of_a); ++i)
    for (std::size_t k = 0; k < (b.is_patch() ? 1 : of_b); ++k) {
      const double found =
          a.is_patch() ? (b.is_patch() ? kernel.mean : mean_b[k]) : (b.is_patch() ? mean_a[i] : value[i][k]);
      double fitted = kernel.mean;
      if (!a.is_patch()) fitted += kernel.slope_a.dot(a.samples[i].position - a.center);
      if (!b.is_patch()) fitted += kernel.slope_b.dot(b.samples[k].position - b.center);
      kernel.residual = std::max(kernel.residual, std::abs(found - fitted));
    }
  return kernel;
}

bool are_behind(const PatchNode& a, const PatchNode& b) { return is_behind(a, b) || is_behind(b, a); }

bool are_apart(const PatchNode& a, const PatchNode& b) {
  return std::max(a.spread, b.spread) < one_side && (a.center - b.center).norm() > a.radius + b.radius;
}

}  // namespace etendue
