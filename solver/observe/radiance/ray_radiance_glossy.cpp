// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What a picture sees of walls with a reflectance f_r.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "solver/observe/radiance/ray_radiance.h"
#include "solver/observe/radiance/ray_radiance_segment.h"
#include "solver/uncollided/sources/sky_source.h"
#include "solver/uncollided/sources/wide_source.h"

namespace etendue {
namespace {

/// Lobes that are narrower than this [radian] show the single rays to a lamp with an extent; they are drawn
/// from instead.
constexpr double narrow = 0.2;

/// Numbers on [0, 1) that belong to a place: rays from neighbouring pixels do not fall together into images.
struct Shift {
  double u, v;
};
Shift shift_at(const Vec3& place) {
  std::uint64_t hash = 0x9E3779B97F4A7C15ULL;
  for (int axis = 0; axis < 3; ++axis) {
    // The mixing of SplitMix64 (Steele, Lea and Flood 2014).
    hash += std::bit_cast<std::uint64_t>(place[axis]);
    hash = (hash ^ (hash >> 30)) * 0xBF58476D1CE4E5B9ULL;
    hash = (hash ^ (hash >> 27)) * 0x94D049BB133111EBULL;
    hash ^= hash >> 31;
  }
  constexpr double part = 1.0 / 4294967296.0;
  return {static_cast<double>(hash & 0xFFFFFFFF) * part, static_cast<double>(hash >> 32) * part};
}

double fraction(double x) { return x - std::floor(x); }

/// Parts of a sky without a solid angle are single beams, which no ray meets.
bool rays_see(const WideSource& light) {
  const SkySource* sky = light.as_sky();
  return sky == nullptr || sky->shows_radiance();
}

/// The first band's lobe that there is: others have other values in the same directions.
const Reflectance* drawn_from(const Wall& wall) {
  for (const auto& lobe : wall.glossy)
    if (lobe != nullptr) return lobe.get();
  return nullptr;
}

}  // namespace

void RayRadiance::add_glossy(FaceIndex face, const Vec3& point, const RaySegment& segment, Workspace& work,
                             std::span<double> radiance) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  if (!wall.is_glossy()) return;
  std::vector<double> sum(bands_, 0);
  if (segment.view.glossy == 0) {
    std::vector<double> share;
    for (std::size_t b = 0; b < bands_; ++b)
      share.push_back(wall.glossy_in(b) != nullptr ? wall.glossy_in(b)->albedo().mean() : 0);
    walls_.add_sent_on(face, point, share, walls_.brought(), segment.view.shadow_rays, work.beams, sum);
  } else {
    add_glossy_lights(face, point, segment, work, sum);
    add_glossy_rays(face, point, segment, work, sum);
  }
  for (std::size_t b = 0; b < bands_; ++b)
    radiance[b] += work.factor[b] * std::exp(-work.depth_rest[b]) * sum[b];
}

// f_r E of each beam of the lights that the drawn rays do not see.
void RayRadiance::add_glossy_lights(FaceIndex face, const Vec3& point, const RaySegment& segment,
                                    Workspace& work, std::span<double> sum) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  const Vec3 inwards = -problem_.mesh().area_normal(face).normalized();
  LightBeams clear(bands_);
  const bool rays_see_lamps = drawn_from(wall)->width() < narrow;
  for (const auto& source : lights_.sources()) {
    const WideSource* wide = source->as_wide();
    if (rays_see_lamps && wide != nullptr && rays_see(*wide)) continue;
    walls_.find_beams(*source, {problem_.mesh().owner(face), point}, segment.view.shadow_rays, work.beams,
                      clear);
    for (std::size_t k = 0; k < work.beams.size(); ++k) {
      const double cosine = -inwards.dot(work.beams.direction(k));
      for (std::size_t b = 0; b < bands_ && cosine > 0; ++b)
        if (const Reflectance* lobe = wall.glossy_in(b))
          sum[b] += lobe->between(work.beams.direction(k), segment.travel(), inwards) * cosine *
                    work.beams.fluence(k)[b];
    }
  }
}

// By reciprocity light comes from where a lobe around the light's own way back points.
void RayRadiance::add_glossy_rays(FaceIndex face, const Vec3& point, const RaySegment& segment,
                                  Workspace& work, std::span<double> sum) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  const Reflectance& drawn = *drawn_from(wall);
  const Vec3 inwards = -problem_.mesh().area_normal(face).normalized();
  const Vec3 travel = segment.travel();
  const double cosine = std::min(1.0, travel.dot(inwards));
  if (cosine <= 0) return;
  if (work.inner == nullptr) work.inner = std::make_unique<Workspace>(*this);
  // Many rays meet walls beyond: the steps of a penumbra that few rays leave are lost among them.
  const RayView view{.glossy = 0,
                     .lights_shown = drawn.width() < narrow,
                     .shadow_rays = std::min(segment.view.shadow_rays, quick_shadow_rays)};
  const int rays = segment.view.glossy;
  const Shift shift = shift_at(point);
  std::vector<double> incoming(bands_);
  for (int i = 0; i < rays; ++i) {
    // Roberts' (2018) sequence, by the root of x^3 = x + 1.
    constexpr double root = 1.32471795724474602596;
    const ReflectedRay ray =
        drawn.sample(cosine, fraction(shift.u + i / root), fraction(shift.v + i / (root * root)));
    if (ray.weight <= 0) continue;
    const Vec3 towards = from_frame(ray.direction, travel, inwards);
    along({problem_.mesh().owner(face), point}, towards, view, *work.inner, incoming);
    const double value = drawn.between(-travel, towards, inwards);
    for (std::size_t b = 0; b < bands_; ++b)
      if (const Reflectance* lobe = wall.glossy_in(b))
        sum[b] += incoming[b] * ray.weight / rays *
                  (lobe == &drawn ? 1 : lobe->between(-travel, towards, inwards) / value);
  }
}

}  // namespace etendue
