// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/uniform_emitters.h"

#include <algorithm>
#include <cmath>

#include "base/clipped_polygon.h"
#include "solver/uncollided/closed_form/outline.h"
#include "solver/uncollided/closed_form/triangle.h"

namespace etendue {
namespace {

/// Emitters among which each triangle is searched.
constexpr std::size_t most_emitters = 64;
EmitterPart triangle_of(const std::array<Vec3, 3>& corners, const std::vector<double>& radiance) {
  return {{corners[0], corners[1], corners[2], Vec3::Zero()}, radiance};
}

}  // namespace

std::optional<std::vector<UniformEmitter>> uniform_emitters(std::span<const EmitterPart> triangles,
                                                            std::size_t most) {
  std::vector<UniformEmitter> emitters;
  for (const EmitterPart& part : triangles) {
    const std::array<Vec3, 3> triangle = {part.corners[0], part.corners[1], part.corners[2]};
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
    const double size = (triangle[1] - triangle[0]).norm();
    const auto same = [&](const UniformEmitter& emitter) {
      return emitter.radiance == part.brightness && (emitter.normal - normal).norm() < one_plane &&
             std::abs(normal.dot(triangle[0]) - emitter.offset) < one_plane * size;
    };
    auto emitter = std::find_if(emitters.begin(), emitters.end(), same);
    if (emitter == emitters.end()) {
      if (emitters.size() == most) return std::nullopt;
      emitter = emitters.insert(emitter, {normal, normal.dot(triangle[0]), part.brightness, {}});
    }
    emitter->triangles.push_back(triangle);
  }
  return emitters;
}

bool shines_to(const EmitterPart& triangle, const Vec3& eye) {
  const Vec3 a = triangle.corners[0] - eye, b = triangle.corners[1] - eye, c = triangle.corners[2] - eye;
  const Vec3 normal = (b - a).cross(c - a);
  return -normal.dot(a) > rounding_height * normal.norm() * std::max({a.norm(), b.norm(), c.norm()});
}

std::vector<EmitterPart> few_triangles(std::span<const EmitterPart> triangles) {
  const std::optional<std::vector<UniformEmitter>> emitters = uniform_emitters(triangles, most_emitters);
  if (!emitters) return {triangles.begin(), triangles.end()};
  std::vector<EmitterPart> few;
  for (const UniformEmitter& emitter : *emitters) {
    const std::vector<Vec3> corners = convex_outline(emitter.triangles, emitter.normal);
    const bool fewer = !corners.empty() && corners.size() - 2 < emitter.triangles.size();
    for (std::size_t i = 2; fewer && i < corners.size(); ++i)
      few.push_back(triangle_of({corners[0], corners[i - 1], corners[i]}, emitter.radiance));
    for (std::size_t i = 0; !fewer && i < emitter.triangles.size(); ++i)
      few.push_back(triangle_of(emitter.triangles[i], emitter.radiance));
  }
  return few;
}

}  // namespace etendue
