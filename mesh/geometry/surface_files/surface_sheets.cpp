// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/surface_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/position.h"
#include "mesh/geometry/primitives/primitive_checks.h"

namespace etendue {
namespace {

/// The numbers that points have in a surface; those that it lacks are added.
std::vector<int> numbers_in(SurfaceComplex& surface, const std::vector<Vec3>& points) {
  std::map<std::array<double, 3>, int> known;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const Vec3& p = surface.points[i];
    known.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(i));
  }
  std::vector<int> numbers;
  for (const Vec3& p : points) {
    const auto [entry, added] =
        known.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(surface.points.size()));
    if (added) surface.points.push_back(p);
    numbers.push_back(entry->second);
  }
  return numbers;
}

int wall_number(SurfaceComplex& surface, const std::string& name) {
  const auto known = std::ranges::find(surface.wall_names, name);
  const auto number = known - surface.wall_names.begin();
  if (known == surface.wall_names.end()) surface.wall_names.push_back(name);
  return static_cast<int>(number);
}

}  // namespace

void add_sheets(const OpenSurface& open, SurfaceComplex& surface,
                const std::function<bool(const Vec3&)>& is_filled) {
  const std::vector<int> number = numbers_in(surface, open.points);
  for (std::size_t t = 0; t < open.triangles.size(); ++t) {
    const auto& [a, b, c] = open.triangles[t];
    const Vec3 &from = open.points[position(a)], &to = open.points[position(b)],
               &third = open.points[position(c)];
    const Vec3 centroid = (from + to + third) / 3;
    if (!is_filled(centroid))
      throw std::invalid_argument(
          fmt::format("the surface is not closed: it has a border, and lies in no closed part (at {}); close "
                      "it, or move it into one, where it becomes a sheet",
                      text_of(centroid)));
    const int front = open.walls[t];
    const int back = wall_number(surface, surface.wall_names[position(front)] + ".back");
    SurfaceFacet facet{{{number[position(a)], number[position(b)], number[position(c)]}}, {}};
    facet.sheet = static_cast<int>(surface.sheets.size());
    surface.facets.push_back(std::move(facet));
    surface.sheets.push_back({front, back, (to - from).cross(third - from).normalized()});
  }
}

}  // namespace etendue
