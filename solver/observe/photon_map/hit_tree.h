// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "solver/photons/kernel/photon_scene.h"

namespace etendue {

/// Hits near a point.
struct NearHits {
  std::vector<std::uint32_t> number;  ///< of the hits, nearest first
  double radius = 0;                  ///< of the ball that they were found in [length]
};

/// Hits in a tree that finds the nearest (nanoflann). May be asked by several threads at a time.
class HitTree {
 public:
  /// The hits must outlive it.
  explicit HitTree(std::span<const PhotonHit> hits);
  ~HitTree();
  HitTree(HitTree&&) noexcept;
  HitTree& operator=(HitTree&&) noexcept;

  /// The `count` hits nearest to a point but the last of them, which gives the radius: then the number over
  /// the ball's size is the density without bias (Loftsgaarden and Quesenberry 1965; Fukunaga 1990,
  /// section 6.2). There must be as many.
  void nearest(const Vec3& point, std::size_t count, NearHits& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace etendue
