// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/primitives/wall_naming.h"

#include <algorithm>

#include "mesh/geometry/primitives/primitive_checks.h"

namespace etendue {
namespace {

int hole_primitive(SpaceLabel label) { return -2 - label; }

void add_named_sides(const BoxPrimitive& box, int primitive, std::vector<NamedRectangle>& rectangles) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int outward : {-1, 1}) {
      const auto named = box.walls.find(side_name(axis, outward));
      if (named == box.walls.end()) continue;
      NamedRectangle side{axis, outward, box.min, box.max, named->second, primitive, -1};
      (outward < 0 ? side.max : side.min)[axis] = (outward < 0 ? box.min : box.max)[axis];
      rectangles.push_back(side);
    }
  }
}

}  // namespace

std::vector<NamedRectangle> named_rectangles(const Geometry& geometry) {
  std::vector<NamedRectangle> rectangles;
  for (std::size_t i = 0; i < geometry.primitives.size(); ++i) {
    const auto* box = std::get_if<BoxPrimitive>(&geometry.primitives[i]);
    if (box && !box->hole) add_named_sides(*box, static_cast<int>(i), rectangles);
  }
  for (std::size_t i = 0; i < geometry.patches.size(); ++i) {
    const Patch& patch = geometry.patches[i];
    int axis = 0;
    while (patch.min[axis] != patch.max[axis]) ++axis;
    rectangles.push_back({axis, 0, patch.min, patch.max, patch.wall, -1, static_cast<int>(i)});
  }
  return rectangles;
}

std::vector<SpaceLabel> primitive_labels(const Geometry& geometry, std::vector<std::string>& region_names) {
  std::vector<SpaceLabel> labels;
  for (std::size_t i = 0; i < geometry.primitives.size(); ++i) {
    const PrimitiveBase& base = base_of(geometry.primitives[i]);
    if (base.hole) {
      labels.push_back(hole_label(static_cast<int>(i)));
      continue;
    }
    const auto known = std::find(region_names.begin(), region_names.end(), base.region);
    labels.push_back(static_cast<int>(known - region_names.begin()));
    if (known == region_names.end()) region_names.push_back(base.region);
  }
  return labels;
}

int WallNames::number(const std::string& name) {
  const auto known = std::find(names_.begin(), names_.end(), name);
  const auto number = known - names_.begin();
  if (known == names_.end()) names_.push_back(name);
  return static_cast<int>(number);
}

std::string side_name(int axis, int outward) {
  return std::string(1, "xyz"[axis]) + (outward < 0 ? "min" : "max");
}

bool may_name(const NamedRectangle& rectangle, SpaceLabel beyond) {
  if (rectangle.patch >= 0 || beyond == kOutside) return true;
  return rectangle.primitive > hole_primitive(beyond);
}

std::string default_name(const Geometry& geometry, SpaceLabel beyond, int axis, int outward) {
  if (beyond == kOutside) return side_name(axis, outward);
  const Primitive& hole = geometry.primitives[static_cast<std::size_t>(hole_primitive(beyond))];
  const std::string& name = base_of(hole).name;
  // The side of the hole that faces the domain: opposite to the domain's own outward normal.
  return std::holds_alternative<BoxPrimitive>(hole) ? name + "." + side_name(axis, -outward) : name;
}

}  // namespace etendue
