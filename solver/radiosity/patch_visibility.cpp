// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/patch_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/photons/random_stream.h"
#include "solver/radiosity/wall_patches.h"

namespace etendue {
namespace {

// Where some rays are blocked, so many times the rays are sent.
constexpr int rays_of_shadows = 8;
// Distance behind a plane, relative to the size of a patch and its distance, that is rounding.
constexpr double behind = 1e-9;

/// A sequence that fills the unit cube of four dimensions evenly: steps of 1/g, 1/g^2, …, g^5 = g + 1
/// (Roberts 2018), begun somewhere.
class EvenPoints {
 public:
  explicit EvenPoints(std::uint64_t number) {
    RandomStream stream(0, number, RandomUse::form_factor);
    std::uint32_t word[4];
    stream.next(word);
    for (std::size_t i = 0; i < 4; ++i) place_[i] = uniform(word[i]);
  }
  const std::array<double, 4>& next() {
    constexpr std::array<double, 4> step = {0.8566748838545029, 0.7338918566271260, 0.6287067210378087,
                                            0.5385972572236101};
    for (std::size_t i = 0; i < 4; ++i) {
      place_[i] += step[i];
      place_[i] -= std::floor(place_[i]);
    }
    return place_;
  }

 private:
  std::array<double, 4> place_{};
};

/// A point of a patch for two numbers in (0, 1).
Vec3 point_of(const FlatPatch& patch, double u, double v) {
  double rest = u * patch.area();
  for (const TriangleCorners& t : patch.triangles()) {
    const double area = (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
    if (rest > area && &t != &patch.triangles().back()) {
      rest -= area;
      continue;
    }
    const double root = std::sqrt(std::clamp(rest / area, 0.0, 1.0));
    return (1 - root) * t[0] + root * (1 - v) * t[1] + root * v * t[2];
  }
  return patch.centroid();
}

bool all_before(const std::vector<FlatPatch>& patches, const FlatPatch& plane) {
  for (const FlatPatch& patch : patches) {
    const Vec3 way = patch.centroid() - plane.centroid();
    if (plane.normal().dot(way) > patch.radius()) continue;
    const double close = behind * (way.norm() + patch.radius() + plane.radius());
    for (const TriangleCorners& t : patch.triangles())
      for (const Vec3& corner : t)
        if (plane.normal().dot(corner - plane.centroid()) < -close) return false;
  }
  return true;
}

struct Seen {
  double open = 0, all = 0;
  int blocked = 0, sent = 0;
};

}  // namespace

PatchVisibility::PatchVisibility(const std::vector<FlatPatch>& patches, int rays, int threads)
    : patches_(patches), rays_(rays) {
  if (!std::ranges::all_of(patches, [&](const FlatPatch& plane) { return all_before(patches, plane); }))
    scene_ = std::make_unique<RayScene>(triangles_of(patches), threads);
}

double PatchVisibility::share(std::size_t a, std::size_t b) const {
  if (is_convex()) return 1;
  const std::size_t low = std::min(a, b), high = std::max(a, b);
  const FlatPatch &first = patches_[low], &second = patches_[high];
  EvenPoints points(low * patches_.size() + high);
  Seen seen;
  const auto send = [&](int rays) {
    for (int i = 0; i < rays; ++i) {
      const std::array<double, 4>& at = points.next();
      const Vec3 from = point_of(first, at[0], at[1]), to = point_of(second, at[2], at[3]);
      const Vec3 way = to - from;
      const double r2 = way.squaredNorm();
      const double carried = first.normal().dot(way) * -second.normal().dot(way) / (r2 * r2);
      if (!(carried > 0)) continue;
      ++seen.sent;
      seen.all += carried;
      if (scene_->is_blocked(from, to))
        ++seen.blocked;
      else
        seen.open += carried;
    }
  };
  send(rays_);
  if (seen.blocked > 0 && seen.blocked < seen.sent) send((rays_of_shadows - 1) * rays_);
  // Where no ray carries anything, hardly a corner of one is before the other.
  return seen.all > 0 ? seen.open / seen.all : 1;
}

double PatchVisibility::share_from(const Vec3& point, std::size_t patch, int rays) const {
  if (is_convex()) return 1;
  const FlatPatch& seen = patches_[patch];
  if (rays == 1) return scene_->is_blocked(point, seen.centroid()) ? 0 : 1;
  EvenPoints points(patch);
  double open = 0, all = 0;
  for (int i = 0; i < rays; ++i) {
    const std::array<double, 4>& at = points.next();
    const Vec3 to = point_of(seen, at[0], at[1]), way = to - point;
    const double carried = -seen.normal().dot(way) / (way.squaredNorm() * way.norm());
    if (!(carried > 0)) continue;
    all += carried;
    if (!scene_->is_blocked(point, to)) open += carried;
  }
  return all > 0 ? open / all : 1;
}

}  // namespace etendue
