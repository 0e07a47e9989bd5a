// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/rays/light_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/vector_sums.h"

namespace etendue {
namespace {

/// A wall that stands this part of the path before its end is where the light is.
constexpr double end_of_path = 1e-9;
/// Mirrors on one path after which it is given up: nothing that counts comes from there.
constexpr int most_reflections = 10000;

std::vector<double> extinction_of(const Problem& problem, std::span<const double> added) {
  std::vector<double> extinction(problem.absorption().begin(), problem.absorption().end());
  add_to(extinction, problem.scattering());
  if (!added.empty()) add_to(extinction, added);
  return extinction;
}

}  // namespace

LightPaths::LightPaths(const Problem& problem, std::vector<double> added)
    : problem_(problem),
      bands_(static_cast<std::size_t>(problem.band_count())),
      rays_(problem.mesh()),
      mirrors_(problem),
      matter_(problem),
      added_(std::move(added)),
      extinction_(extinction_of(problem, added_)) {}

double LightPaths::largest_extinction(CellIndex cell) const {
  const auto first = extinction_.begin() + static_cast<std::ptrdiff_t>(cell.at() * bands_);
  return *std::max_element(first, first + static_cast<std::ptrdiff_t>(bands_));
}

RayEnd LightPaths::walk(const PointInCell& from, const Vec3& direction, double length,
                        std::span<double> depth) const {
  if (!matter_.empty()) {
    const RayMatter::View light = matter_.view(-direction);
    double reached = 0;
    return rays_.walk(from.cell, from.position, direction, length, [&](CellIndex cell, double part) {
      if (!matter_.varies(cell) && !matter_.depends_on_direction(problem_.mesh().region(cell))) {
        const double* extinction = &extinction_[cell.at() * bands_];
        for (std::size_t b = 0; b < bands_; ++b) depth[b] += extinction[b] * part;
      } else {
        // What is linear has its mean in the middle.
        const Vec3 middle = from.position + (reached + part / 2) * direction;
        for (std::size_t b = 0; b < bands_; ++b)
          depth[b] += (matter_.at(cell, b, light, middle).extinction() + added(cell, b)) * part;
      }
      reached += part;
    });
  }
  if (bands_ > 1)
    return rays_.walk(from.cell, from.position, direction, length, [&](CellIndex cell, double part) {
      const double* extinction = &extinction_[cell.at() * bands_];
      for (std::size_t b = 0; b < bands_; ++b) depth[b] += extinction[b] * part;
    });
  double only = 0;
  const RayEnd end = rays_.walk(from.cell, from.position, direction, length,
                                [&](CellIndex cell, double part) { only += extinction_[cell.at()] * part; });
  depth[0] += only;
  return end;
}

void LightPaths::reflect(FaceIndex face, std::span<double> factor) const {
  const Wall& wall = problem_.wall(problem_.mesh().wall(face));
  for (std::size_t b = 0; b < bands_; ++b) factor[b] -= std::log(wall.specular[b]);
}

// `transmittance` holds the optical depth of the path; a mirror adds -log of its reflectance.
bool LightPaths::transmit(const PointInCell& from, const Vec3& direction, double length, MirrorSet mirrors,
                          std::span<double> transmittance) const {
  std::fill(transmittance.begin(), transmittance.end(), 0.0);
  PointInCell at = from;
  Vec3 along = direction;
  double left = length;
  while (true) {
    const RayEnd end = walk(at, along, left, transmittance);
    left -= end.distance;
    const bool at_end = left <= end_of_path * length;
    // What touches a mirror is seen behind it at once, but still via it.
    if (!end.wall) {
      if (!mirrors_.touches(mirrors, at.position + end.distance * along, end_of_path * length)) return false;
      break;
    }
    const int plane = mirrors_.of(*end.wall);
    if (plane >= 0 && (mirrors >> plane & 1) != 0) {
      mirrors &= ~(MirrorSet{1} << plane);
      reflect(*end.wall, transmittance);
      at = {end.cell, end.point};
      along = mirrors_.reflected(plane, along);
    } else if (!at_end) {
      return false;
    }
    if (at_end && mirrors_.touches(mirrors, end.point, end_of_path * length)) break;
    if (at_end) return false;
  }
  for (std::size_t b = 0; b < bands_; ++b)
    transmittance[b] = mirrors_.reflectance(mirrors, b) * std::exp(-transmittance[b]);
  return true;
}

std::optional<WayOut> LightPaths::leave(const PointInCell& from, const Vec3& direction,
                                        std::span<double> transmittance) const {
  std::fill(transmittance.begin(), transmittance.end(), 0.0);
  PointInCell at = from;
  Vec3 along = direction;
  for (int i = 0; i < most_reflections; ++i) {
    const RayEnd end = walk(at, along, std::numeric_limits<double>::infinity(), transmittance);
    const int plane = mirrors_.of(*end.wall);
    if (plane < 0) {
      for (double& value : transmittance) value = std::exp(-value);
      return WayOut{*end.wall, along, end.point};
    }
    reflect(*end.wall, transmittance);
    at = {end.cell, end.point};
    along = mirrors_.reflected(plane, along);
  }
  return std::nullopt;
}

}  // namespace etendue
