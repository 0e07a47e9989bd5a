// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "solver/radiosity/form_factors/flat_patch.h"
#include "solver/radiosity/form_factors/ray_scene.h"
#include "solver/radiosity/patches/patch_tree.h"

namespace etendue {

/// What patches of closed walls see of each other.
class PatchVisibility {
 public:
  /// `rays` are sent between two patches, and eight times as many where some of them are blocked. The patches
  /// must outlive it.
  PatchVisibility(const std::vector<FlatPatch>& patches, int rays, int threads);

  /// No patch lies behind the plane of another: then nothing is between any two points.
  bool is_convex() const { return scene_ == nullptr; }
  /// Unoccluded part of the exchange of two patches: shares of rays between points
  /// all over both, each counting by what it carries. The same for a pair in either order.
  double share(std::size_t a, std::size_t b) const;
  /// The same between two nodes of a tree of these patches.
  double share(const PatchTree& tree, std::size_t a, std::size_t b) const;
  /// The part of a patch's solid angle that a point sees, by so many rays; more where some are blocked.
  double share_from(const Vec3& point, std::size_t patch, int rays) const;

 private:
  const std::vector<FlatPatch>& patches_;
  int rays_;
  std::unique_ptr<RayScene> scene_;  ///< none where the walls are convex
};

}  // namespace etendue
