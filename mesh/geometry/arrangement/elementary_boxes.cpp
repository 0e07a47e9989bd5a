// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/elementary_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mesh/geometry/arrangement/smallest_gap.h"

namespace etendue {
namespace {

struct PlaneSource {
  double coordinate;
  const Origin* origin;
};

std::vector<PlaneSource> plane_sources(const Geometry& geometry, int axis) {
  std::vector<PlaneSource> sources;
  for (const Primitive& primitive : geometry.primitives) {
    const auto& box = std::get<BoxPrimitive>(primitive);
    sources.push_back({box.min[axis], &box.origin});
    sources.push_back({box.max[axis], &box.origin});
  }
  for (const Patch& patch : geometry.patches) {
    sources.push_back({patch.min[axis], &patch.origin});
    sources.push_back({patch.max[axis], &patch.origin});
  }
  std::stable_sort(sources.begin(), sources.end(),
                   [](const PlaneSource& a, const PlaneSource& b) { return a.coordinate < b.coordinate; });
  return sources;
}

std::vector<double> distinct_planes(const Geometry& geometry, int axis, double scene_size) {
  std::vector<double> planes;
  for (const PlaneSource& source : plane_sources(geometry, axis)) {
    if (!planes.empty() && source.coordinate == planes.back()) continue;
    if (!planes.empty() && source.coordinate - planes.back() < smallest_gap * scene_size)
      throw InputError(fault_at(*source.origin, "",
                                fmt::format("{0} = {1} and {0} = {2} are nearly but not quite the same plane "
                                            "(the gap cannot be meshed); make them equal",
                                            "xyz"[axis], planes.back(), source.coordinate)));
    planes.push_back(source.coordinate);
  }
  return planes;
}

double scene_size(const Geometry& geometry) {
  double size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<PlaneSource> sources = plane_sources(geometry, axis);
    size = std::max(size, sources.back().coordinate - sources.front().coordinate);
  }
  return size;
}

}  // namespace

ElementaryBoxes::ElementaryBoxes(const Geometry& geometry, const std::vector<SpaceLabel>& labels) {
  const double size = scene_size(geometry);
  std::size_t boxes = 1;
  for (int axis = 0; axis < 3; ++axis) {
    planes_[static_cast<std::size_t>(axis)] = distinct_planes(geometry, axis, size);
    boxes *= static_cast<std::size_t>(count(axis));
  }
  labels_.assign(boxes, kOutside);
  for (std::size_t i = 0; i < labels.size(); ++i)
    fill(std::get<BoxPrimitive>(geometry.primitives[i]), labels[i]);
}

ElementaryBoxes::ElementaryBoxes(std::array<std::vector<double>, 3> planes, std::vector<SpaceLabel> labels)
    : planes_(std::move(planes)), labels_(std::move(labels)) {}

bool ElementaryBoxes::contains(const GridIndex& box) const {
  for (int axis = 0; axis < 3; ++axis)
    if (box[static_cast<std::size_t>(axis)] < 0 || box[static_cast<std::size_t>(axis)] >= count(axis))
      return false;
  return true;
}

std::size_t ElementaryBoxes::at(const GridIndex& box) const {
  const auto ny = static_cast<std::size_t>(count(1));
  const auto nz = static_cast<std::size_t>(count(2));
  return (static_cast<std::size_t>(box[0]) * ny + static_cast<std::size_t>(box[1])) * nz +
         static_cast<std::size_t>(box[2]);
}

Vec3 ElementaryBoxes::corner(const GridIndex& node) const {
  return {plane(0, node[0]), plane(1, node[1]), plane(2, node[2])};
}

Vec3 ElementaryBoxes::middle(const GridIndex& box) const {
  return 0.5 * (corner(box) + corner({box[0] + 1, box[1] + 1, box[2] + 1}));
}

double ElementaryBoxes::thickness(const GridIndex& box) const {
  return (corner({box[0] + 1, box[1] + 1, box[2] + 1}) - corner(box)).minCoeff();
}

int ElementaryBoxes::plane_index(int axis, double coordinate) const {
  const std::vector<double>& planes = planes_[static_cast<std::size_t>(axis)];
  return static_cast<int>(std::lower_bound(planes.begin(), planes.end(), coordinate) - planes.begin());
}

void ElementaryBoxes::fill(const BoxPrimitive& box, SpaceLabel label) {
  GridIndex first{}, last{};
  for (int axis = 0; axis < 3; ++axis) {
    first[static_cast<std::size_t>(axis)] = plane_index(axis, box.min[axis]);
    last[static_cast<std::size_t>(axis)] = plane_index(axis, box.max[axis]);
  }
  for (int i = first[0]; i < last[0]; ++i)
    for (int j = first[1]; j < last[1]; ++j)
      for (int k = first[2]; k < last[2]; ++k) labels_[at({i, j, k})] = label;
}

}  // namespace etendue
