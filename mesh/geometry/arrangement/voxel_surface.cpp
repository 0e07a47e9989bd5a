// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/voxel_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mesh/geometry/arrangement/box_arrangement.h"

namespace etendue {
namespace {

/// Voxels that are left out are one hole, whose walls all have its name, as those of a ball.
const std::string left_out_name = "surface";
constexpr SpaceLabel left_out = hole_label(0);

Geometry naming_geometry() {
  SpherePrimitive hole;
  hole.hole = true;
  hole.name = left_out_name;
  Geometry geometry;
  geometry.primitives.emplace_back(hole);
  return geometry;
}

[[noreturn]] void fail(const Origin& origin, const std::string& problem) {
  throw InputError(fault_at(origin, "", problem));
}

/// The number of each label's region, in the order of the names.
std::map<int, int> region_numbers(const std::map<std::string, int>& labels, const Origin& origin) {
  std::map<int, int> numbers;
  for (const auto& [name, label] : labels)
    if (!numbers.try_emplace(label, static_cast<int>(numbers.size())).second)
      fail(origin, fmt::format("the label {} is given to two regions", label));
  return numbers;
}

/// The region of each value; each region has some.
std::vector<SpaceLabel> regions_of(const std::vector<double>& values,
                                   const std::map<std::string, int>& labels, const Origin& origin) {
  const std::map<int, int> numbers = region_numbers(labels, origin);
  std::vector<SpaceLabel> regions;
  regions.reserve(values.size());
  for (const double value : values) {
    if (!(std::abs(value) <= std::numeric_limits<int>::max()) || value != std::floor(value))
      fail(origin, fmt::format("voxel {} has the value {}; labels are whole numbers", regions.size(), value));
    const auto found = numbers.find(static_cast<int>(value));
    regions.push_back(found == numbers.end() ? left_out : found->second);
  }
  for (const auto& [name, label] : labels)
    if (std::ranges::count(regions, numbers.at(label)) == 0)
      fail(origin, fmt::format("no voxel has the label {} (region {})", label, name));
  return regions;
}

/// From the first index as the fastest to the last.
std::vector<SpaceLabel> with_last_fastest(const std::vector<SpaceLabel>& regions,
                                          const std::array<int, 3>& counts) {
  std::vector<SpaceLabel> result;
  result.reserve(regions.size());
  for (int i = 0; i < counts[0]; ++i)
    for (int j = 0; j < counts[1]; ++j)
      for (int k = 0; k < counts[2]; ++k)
        result.push_back(
            regions[static_cast<std::size_t>((k * counts[1] + j)) * static_cast<std::size_t>(counts[0]) +
                    static_cast<std::size_t>(i)]);
  return result;
}

/// The name in space of a side that is named by an axis of the image; other names stay.
std::string name_in_space(const std::string& name, const Eigen::Matrix3d& axes) {
  for (int axis = 0; axis < 3; ++axis)
    for (const int outward : {-1, 1}) {
      if (name != side_name(axis, outward)) continue;
      int most = 0;
      axes.col(axis).cwiseAbs().maxCoeff(&most);
      return side_name(most, outward * axes(most, axis) > 0 ? 1 : -1);
    }
  return name;
}

/// Walls of one name become one.
void rename_walls(const Eigen::Matrix3d& axes, SurfaceComplex& surface) {
  WallNames names;
  std::vector<int> number;
  for (const std::string& name : surface.wall_names)
    number.push_back(names.number(name_in_space(name, axes)));
  for (SurfaceFacet& facet : surface.facets)
    if (facet.wall >= 0) facet.wall = number[static_cast<std::size_t>(facet.wall)];
  surface.wall_names = names.all();
}

}  // namespace

VoxelSurface voxel_surface(const FieldData& image, const std::map<std::string, int>& labels,
                           const Origin& origin, FacetSize size) {
  const ImageGrid& grid = *image.image;
  const bool on_points = image.on == FieldValues::on_points;
  std::array<int, 3> counts = grid.points;
  if (!on_points)
    for (int& count : counts) --count;
  std::array<std::vector<double>, 3> planes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int i = 0; i <= counts[axis]; ++i)
      planes[axis].push_back(i * grid.steps.col(static_cast<Eigen::Index>(axis)).norm());
  const std::vector<SpaceLabel> regions = regions_of(image.values, labels, origin);
  VoxelSurface result{arrange_grid(naming_geometry(), {planes, with_last_fastest(regions, counts)}, size),
                      grid.steps.colwise().normalized(), grid.origin};
  if (on_points) result.origin -= 0.5 * grid.steps * Vec3::Ones();
  for (const auto& [name, label] : labels) result.surface.region_names.push_back(name);
  rename_walls(result.axes, result.surface);
  return result;
}

}  // namespace etendue
