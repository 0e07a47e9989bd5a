// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/case/keys/case_tables.h"
#include "app/case/read/read_mesh.h"
#include "mesh/geometry/primitives/sheet_shape.h"

namespace etendue {
namespace {

/// A primitive and where it is in the file.
struct PlacedPrimitive {
  std::int64_t position;
  Primitive primitive;
};

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

std::string new_name(Section& section, const char* key) {
  const std::string name = section.text_if(key).value_or("");
  if (name == "*") section.fault(key, "is reserved for all names without an entry; use another name");
  return name;
}

void read_base(Section& section, PrimitiveBase& base) {
  base.origin = section.origin();
  base.hole = section.boolean("hole");
  if (base.hole) {
    section.unused("region", "a hole has none");
    base.name = new_name(section, "name");
    if (!section.has("name")) section.fault("name", "missing; a hole needs a name for its walls");
  } else {
    section.unused("name", "only a hole has one");
    base.region = new_name(section, "region");
    if (!section.has("region")) section.fault("region", "missing; use the name of a region, or hole = true");
  }
}

// Faulty corners are absent and have been reported.
std::optional<std::pair<Vec3, Vec3>> corners(Section& section) {
  const auto min = section.point_if("min"), max = section.point_if("max");
  if (!min || !max) return std::nullopt;
  return std::pair(*min, *max);
}

BoxPrimitive read_box(Section& section) {
  BoxPrimitive box;
  read_base(section, box);
  if (box.hole) section.unused("walls", "a hole's walls are NAME.xmin to NAME.zmax");
  if (const auto both = corners(section)) {
    std::tie(box.min, box.max) = *both;
    for (int axis = 0; axis < 3; ++axis)
      if (box.max[axis] <= box.min[axis])
        return section.fault("max", fmt::format("not above min in {} ({} <= {}); a box needs min < max",
                                                axes.at(axis), box.max[axis], box.min[axis])),
               box;
  }
  if (const TomlNode* walls = section.find("walls"))
    for (const auto& [side, name] : walls->table().entries) box.walls[side] = name->text();
  return box;
}

SpherePrimitive read_sphere(Section& section) {
  SpherePrimitive sphere;
  read_base(section, sphere);
  sphere_table().read(section, sphere);
  return sphere;
}

CylinderPrimitive read_cylinder(Section& section) {
  CylinderPrimitive cylinder;
  read_base(section, cylinder);
  cylinder_table().read(section, cylinder);
  if (section.find("from") && section.find("to") && cylinder.from == cylinder.to)
    section.fault("to", "the same point as from (a cylinder has a length); use two points");
  return cylinder;
}

Patch read_patch(Section& section) {
  Patch patch;
  patch.origin = section.origin();
  patch.wall = new_name(section, "wall");
  const auto both = corners(section);
  if (!both) return patch;
  std::tie(patch.min, patch.max) = *both;
  const auto flat = (patch.min.array() == patch.max.array()).count();
  if (flat != 1 || (patch.max.array() < patch.min.array()).any())
    section.fault(
        "max",
        "not a rectangle with min; use min and max that agree in exactly one coordinate and rise in the "
        "others");
  return patch;
}

void read_sheet_corners(Section& section, Sheet& sheet) {
  if (section.has("corners")) {
    for (const char* corner : {"min", "max"}) section.unused(corner, "corners says where the sheet is");
    if (const TomlNode* corners = section.find("corners"))
      for (const auto& corner : corners->array()) sheet.corners.push_back(to_vec3(*corner));
  } else if (section.has("min") && section.has("max")) {
    const auto both = corners(section);
    if (!both) return;
    const auto& [min, max] = *both;
    if ((min.array() == max.array()).count() != 1 || (max.array() < min.array()).any())
      return section.fault(
          "max",
          "not a rectangle with min; use min and max that agree in exactly one coordinate and "
          "rise in the others");
    sheet.corners = rectangle_corners(min, max);
  } else {
    return section.fault("corners", "missing; use a list of corners, or min and max of a rectangle");
  }
  if (const std::string fault = sheet_fault(sheet); !fault.empty()) section.fault("corners", fault);
}

Sheet read_sheet(Section& section) {
  Sheet sheet;
  sheet.origin = section.origin();
  sheet.front = new_name(section, "front");
  sheet.back = section.has("back") ? new_name(section, "back") : sheet.front;
  read_sheet_corners(section, sheet);
  return sheet;
}

template <class Reader>
void read_primitives(Section& mesh, const char* list, Reader reader,
                     std::vector<PlacedPrimitive>& primitives) {
  for (Section& section : mesh.list(list)) primitives.push_back({section.node().position, reader(section)});
}

}  // namespace

Geometry read_geometry(Section& mesh) {
  std::vector<PlacedPrimitive> placed;
  read_primitives(mesh, "box", read_box, placed);
  read_primitives(mesh, "sphere", read_sphere, placed);
  read_primitives(mesh, "cylinder", read_cylinder, placed);
  std::ranges::stable_sort(placed, {}, &PlacedPrimitive::position);
  Geometry geometry;
  for (PlacedPrimitive& item : placed) geometry.primitives.push_back(std::move(item.primitive));
  for (Section& section : mesh.list("patch")) geometry.patches.push_back(read_patch(section));
  for (Section& section : mesh.list("sheet")) geometry.sheets.push_back(read_sheet(section));
  return geometry;
}

}  // namespace etendue
