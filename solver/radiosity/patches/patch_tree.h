// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/radiosity/form_factors/flat_patch.h"

namespace etendue {

/// A part of a surface as it is seen from afar.
struct SurfaceSample {
  Vec3 position = Vec3::Zero();
  Vec3 area_normal = Vec3::Zero();  ///< [length^2] sum over the part
  double area = 0;                  ///< [length^2]
};

/// A point of a surface and the normal there.
struct SurfaceSite {
  Vec3 position, normal;
};

/// Samples of a node, at most.
inline constexpr std::size_t most_samples = 8;

/// Patches near each other that look to nearly the same side.
struct PatchNode {
  std::int32_t first = 0, count = 0;  ///< its patches in PatchTree::order()
  std::int32_t children = 0;          ///< the first of two that follow each other; 0: a patch
  Vec3 center = Vec3::Zero();
  double radius = 0;         ///< of a ball about the centre with all of it [length]
  Vec3 axis = Vec3::Zero();  ///< mean normal
  double spread = 0;         ///< largest |normal - axis|
  double thickness = 0;      ///< largest distance from the plane through the centre across the axis [length]
  double area = 0;           ///< [length^2]
  /// The inverse of the mean of (x - centre)(x - centre)^T over its samples, 0 where that is flat
  /// [length^-2]
  Eigen::Matrix3d inverse_inertia = Eigen::Matrix3d::Zero();
  std::int32_t sample_count = 0;
  std::array<SurfaceSample, most_samples> samples{};

  bool is_patch() const { return children == 0; }
};

/// A binary tree over patches: halves by place and by where they look, down to single patches.
class PatchTree {
 public:
  /// The patches must outlive it; at least one.
  explicit PatchTree(const std::vector<FlatPatch>& patches);

  const std::vector<FlatPatch>& patches() const { return patches_; }
  /// The root is the first; children follow their parents.
  const std::vector<PatchNode>& nodes() const { return nodes_; }
  /// Patches from left to right: those of a node stand side by side.
  const std::vector<std::int32_t>& order() const { return order_; }
  std::span<const std::int32_t> patches_of(const PatchNode& node) const {
    return {order_.data() + node.first, static_cast<std::size_t>(node.count)};
  }
  /// A point of a node's patches for three numbers in (0, 1), with the normal there; even by area.
  SurfaceSite site_of(const PatchNode& node, double t, double u, double v) const;

 private:
  void split(std::size_t node);
  void measure(PatchNode& node) const;

  const std::vector<FlatPatch>& patches_;
  std::vector<std::int32_t> order_;
  std::vector<PatchNode> nodes_;
  std::vector<double>
      area_before_;           ///< [place in order() and one more] of the patches to the left [length^2]
  double normal_weight_ = 0;  ///< [length] what a normal counts against a place
};

}  // namespace etendue
