// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/radiance/lit_triangle.h"

namespace etendue {

std::optional<double> distance_to_front(std::span<const Vec3> corners, const Vec3& from,
                                        const Vec3& direction) {
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Vec3 a = corners[i] - from, b = corners[i + 1] - from, c = corners[i + 2] - from;
    const double u = direction.dot(b.cross(c)), v = direction.dot(c.cross(a)), w = direction.dot(a.cross(b));
    // Seen from the front the corners stand counterclockwise, so the ray has all edges alike.
    if (!(u <= 0 && v <= 0 && w <= 0 && u + v + w < 0)) continue;
    const double distance = a.dot(b.cross(c)) / (u + v + w);
    if (distance > 0) return distance;  // a flat light is passed once, on an edge of its triangles too
  }
  return std::nullopt;
}

std::vector<TransmittedLight> transmitted_lights(std::span<const Light> lights, const Vec3& from,
                                                 const Vec3& direction, double length) {
  std::vector<TransmittedLight> found;
  for (const Light& light : lights) {
    const auto* surface = std::get_if<SurfaceLight>(&light.kind);
    if (surface == nullptr) continue;
    const std::optional<double> distance = distance_to_front(surface->triangles, from, direction);
    if (distance && *distance <= length) found.push_back({surface, *distance});
  }
  return found;
}

}  // namespace etendue
