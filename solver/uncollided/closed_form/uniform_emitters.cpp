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
/// Sides of an outline that turn back by more than this are not convex.
constexpr double turns_back = 1e-12;
/// Areas that differ by less are the same.
constexpr double same_area = 1e-9;

/// The corners of a convex outline in order; empty where it is not convex, or not one.
std::vector<Vec3> convex_corners(const UniformEmitter& emitter) {
  const std::vector<Side> sides = outline(emitter.triangles);
  if (sides.empty()) return {};
  std::vector<Vec3> corners{sides.front().first};
  const Side* at = &sides.front();
  while (at->second != corners.front()) {
    corners.push_back(at->second);
    const auto goes_on = [&](const Side& side) { return side.first == corners.back(); };
    if (corners.size() > sides.size() || std::ranges::count_if(sides, goes_on) != 1) return {};
    const Side& next = *std::ranges::find_if(sides, goes_on);
    at = &next;
  }
  if (corners.size() != sides.size()) return {};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &before = corners[i], &here = corners[(i + 1) % corners.size()],
               &after = corners[(i + 2) % corners.size()];
    const Vec3 in = here - before, out = after - here;
    if (emitter.normal.dot(in.cross(out)) < -turns_back * in.norm() * out.norm()) return {};
  }
  return corners;
}

/// Returns whether the triangles about the first corner cover what the emitter's own cover, and lie as they
/// do.
bool stand_for(const std::vector<Vec3>& corners, const UniformEmitter& emitter) {
  const Vec3& first = corners[0];
  double fan = 0, whole = 0, size = 0, height = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) fan += triangle_area({first, corners[i - 1], corners[i]});
  const Vec3 normal = (corners[1] - first).cross(corners[2] - first).normalized();
  for (const std::array<Vec3, 3>& triangle : emitter.triangles) {
    whole += triangle_area(triangle);
    for (const Vec3& corner : triangle) {
      size = std::max(size, (corner - first).norm());
      height = std::max(height, std::abs(normal.dot(corner - first)));
    }
  }
  return height <= rounding_height * size && std::abs(fan - whole) <= same_area * whole;
}

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
    const std::vector<Vec3> corners = convex_corners(emitter);
    const bool fewer =
        corners.size() > 2 && corners.size() - 2 < emitter.triangles.size() && stand_for(corners, emitter);
    for (std::size_t i = 2; fewer && i < corners.size(); ++i)
      few.push_back(triangle_of({corners[0], corners[i - 1], corners[i]}, emitter.radiance));
    for (std::size_t i = 0; !fewer && i < emitter.triangles.size(); ++i)
      few.push_back(triangle_of(emitter.triangles[i], emitter.radiance));
  }
  return few;
}

}  // namespace etendue
