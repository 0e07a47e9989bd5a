// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/radiosity/form_factors/ray_factors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/random/random_stream.h"

namespace etendue {
namespace {

struct LeavingRay {
  Vec3 origin, direction;
};

/// Draws rays of a surface.
class RaySource {
 public:
  explicit RaySource(const std::vector<TriangleCorners>& triangles) : triangles_(triangles) {
    double sum = 0;
    for (const TriangleCorners& t : triangles_) {
      const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
      const Vec3 along = (t[1] - t[0]).normalized(), up = normal.normalized();
      frames_.push_back({along, up.cross(along), up});
      areas_.push_back(sum += normal.norm());
    }
    for (double& area : areas_) area /= sum;
  }

  /// Points even over the area, directions as the cosine.
  LeavingRay ray(std::uint64_t seed, std::uint64_t number) const {
    RandomStream stream(seed, number, RandomUse::form_factor);
    std::array<std::uint32_t[4], 2> words;
    stream.next(words[0]);
    stream.next(words[1]);
    const auto last = static_cast<std::ptrdiff_t>(areas_.size()) - 1;
    const auto found = std::ranges::lower_bound(areas_, uniform(words[0][0])) - areas_.begin();
    const auto i = static_cast<std::size_t>(std::min(found, last));
    const double root = std::sqrt(uniform(words[0][1])), second = uniform(words[0][2]);
    const TriangleCorners& t = triangles_[i];
    const Vec3 origin = (1 - root) * t[0] + root * (1 - second) * t[1] + root * second * t[2];
    const double sine2 = uniform(words[1][0]), turn = 2 * std::numbers::pi * uniform(words[1][1]);
    const double sine = std::sqrt(sine2);
    return {origin, sine * std::cos(turn) * frames_[i][0] + sine * std::sin(turn) * frames_[i][1] +
                        std::sqrt(1 - sine2) * frames_[i][2]};
  }

 private:
  const std::vector<TriangleCorners>& triangles_;
  std::vector<std::array<Vec3, 3>> frames_;
  std::vector<double> areas_;  ///< summed up to each triangle, of 1
};

}  // namespace

std::vector<DrawnFactor> factors_by_rays(const std::vector<TriangleCorners>& from, const RayScene& scene,
                                         const std::vector<std::size_t>& group_of, std::size_t groups,
                                         const LeavingRays& rays, int threads) {
  const RaySource source(from);
  std::vector<std::uint64_t> hits(groups + 1, 0);
#pragma omp parallel num_threads(threads)
  {
    std::vector<std::uint64_t> own(groups + 1, 0);
#pragma omp for schedule(static)
    for (std::uint64_t i = 0; i < rays.count; ++i) {
      const LeavingRay ray = source.ray(rays.seed, i);
      const auto hit = scene.first_hit(ray.origin, ray.direction);
      ++own[hit ? group_of[hit->triangle] : groups];
    }
#pragma omp critical
    for (std::size_t g = 0; g <= groups; ++g) hits[g] += own[g];
  }
  std::vector<DrawnFactor> factors;
  const auto count = static_cast<double>(rays.count);
  for (const std::uint64_t hit : hits) {
    const double share = static_cast<double>(hit) / count;
    factors.push_back({share, std::sqrt(share * (1 - share) / std::max(1.0, count - 1))});
  }
  return factors;
}

}  // namespace etendue
