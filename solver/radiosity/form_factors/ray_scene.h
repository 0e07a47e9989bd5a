// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "solver/radiosity/form_factors/lambert.h"

namespace etendue {

/// Where a ray meets a triangle.
struct SceneHit {
  std::size_t triangle = 0;  ///< its place in the list that the scene was made of
  double distance = 0;       ///< [length]
};

/// Triangles for rays (Embree, in single precision: a point of a hit is off by about 1e-7 of the scene's
/// size). A ray meets fronts only, so one that starts on a wall does not meet that wall again; nor does it
/// meet the other side of a sheet that it starts on.
class RayScene {
 public:
  explicit RayScene(const std::vector<TriangleCorners>& triangles, int threads = 1);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The first triangle on the path; `direction` is a unit vector. Any number of threads may ask.
  std::optional<SceneHit> first_hit(const Vec3& from, const Vec3& direction) const;
  /// Returns whether something is between two points: they may lie on surfaces that face each other.
  bool is_blocked(const Vec3& from, const Vec3& to) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace etendue
