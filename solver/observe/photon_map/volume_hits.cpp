// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/volume_hits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

// Directions in which a ball is looked through for what ends it: beside a wall they give its volume to 1 %.
// First a few look somewhat farther than the ball, which no wall in it escapes: none is as far as 33 degrees
// from all of them.
constexpr std::size_t feelers = 64, scouts = 24;
constexpr double scouted = 1.2;
// A ray that goes so near to all of its length meets nothing.
constexpr double whole_ball = 1 - 1e-12;

/// A spiral of equal solid angles (Saff and Kuijlaars 1997).
template <std::size_t count>
std::array<Vec3, count> spiral() {
  std::array<Vec3, count> directions;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < count; ++i) {
    const double n = static_cast<double>(i), z = 1 - (2 * n + 1) / count, r = std::sqrt(1 - z * z);
    directions[i] = {r * std::cos(golden * n), r * std::sin(golden * n), z};
  }
  return directions;
}

Vec3 position_of(const PhotonHit& hit) { return {hit.position[0], hit.position[1], hit.position[2]}; }

}  // namespace

VolumeHits::VolumeHits(const TetrahedralMesh& mesh, const RayMesh& rays, std::size_t neighbours,
                       const KeptHits& kept)
    : mesh_(mesh), rays_(rays), neighbours_(std::min(neighbours, kept.hits.size())), kept_(kept) {
  if (neighbours_ > 1) tree_.emplace(kept.hits);
}

double VolumeHits::path_in_region(CellIndex start, const Vec3& point, const Vec3& direction,
                                  double length) const {
  const int region = mesh_.region(start);
  double path_length = 0;
  bool inside = true;
  rays_.walk(start, point, direction, length, [&](CellIndex cell, double part) {
    inside = inside && mesh_.region(cell) == region;
    if (inside) path_length += part;
  });
  return path_length;
}

double VolumeHits::volume_seen(CellIndex cell, const Vec3& point, double radius) const {
  static const auto directions = spiral<feelers>();
  double cubes = 0;
  for (const Vec3& direction : directions)
    cubes += std::pow(std::min(path_in_region(cell, point, direction, radius), radius), 3);
  return 4 * std::numbers::pi / 3 * cubes / feelers;
}

bool VolumeHits::around(CellIndex cell, const Vec3& point, Around& found) const {
  static const auto directions = spiral<scouts>();
  found.hits.clear();
  if (!tree_) return false;
  tree_->nearest(point, neighbours_, found.near);
  const double radius = found.radius = found.near.radius;
  if (radius == 0) return false;
  const bool is_free = std::ranges::all_of(directions, [&](const Vec3& direction) {
    return path_in_region(cell, point, direction, scouted * radius) >= whole_ball * scouted * radius;
  });
  if (is_free) {
    found.hits = found.near.number;
    found.volume = 4 * std::numbers::pi / 3 * std::pow(radius, 3);
    return true;
  }
  for (const std::uint32_t number : found.near.number) {
    const Vec3 to = position_of(kept_.hits[number]) - point;
    const double distance = to.norm();
    if (distance == 0 || path_in_region(cell, point, to / distance, distance) >= whole_ball * distance)
      found.hits.push_back(number);
  }
  found.volume = volume_seen(cell, point, radius);
  return found.volume > 0;
}

}  // namespace etendue
