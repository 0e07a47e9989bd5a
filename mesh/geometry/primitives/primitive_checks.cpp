// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/primitives/primitive_checks.h"

#include <fmt/format.h>

#include <cmath>

#include "mesh/geometry/primitives/sheet_shape.h"

namespace etendue {
namespace {

std::string extent_text(const Vec3& min, const Vec3& max) { return text_of(min) + " to " + text_of(max); }

std::string shape_fault(const BoxPrimitive& box) {
  if (!box.min.allFinite() || !box.max.allFinite()) return "coordinates must be finite numbers";
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.min[axis] < box.max[axis]))
      return fmt::format("min must be below max (the box has no extent along {}); swap or move the corners",
                         "xyz"[axis]);
  for (const auto& [side, wall] : box.walls) {
    static constexpr std::string_view kSides = "xmin xmax ymin ymax zmin zmax";
    if (side.size() != 4 || kSides.find(side) == std::string_view::npos)
      return fmt::format("walls.{} is not a side of a box; xmin, xmax, ymin, ymax, zmin or zmax", side);
    if (wall.empty()) return fmt::format("walls.{} is empty; a wall needs a name", side);
  }
  return {};
}

std::string shape_fault(const SpherePrimitive& sphere) {
  if (!sphere.center.allFinite() || !std::isfinite(sphere.radius))
    return "center and radius must be finite numbers";
  if (!(sphere.radius > 0)) return "radius must be above 0 (the sphere has no volume)";
  if (sphere.facets < SpherePrimitive::fewest_facets)
    return fmt::format("facets must be at least {} (the icosahedron)", SpherePrimitive::fewest_facets);
  return {};
}

std::string shape_fault(const CylinderPrimitive& cylinder) {
  if (!cylinder.from.allFinite() || !cylinder.to.allFinite() || !std::isfinite(cylinder.radius))
    return "from, to and radius must be finite numbers";
  if (!(cylinder.radius > 0)) return "radius must be above 0 (the cylinder has no volume)";
  if (cylinder.from == cylinder.to) return "from and to must differ (the cylinder has no length)";
  if (cylinder.facets < CylinderPrimitive::fewest_facets)
    return fmt::format("facets must be at least {} (the sides of a prism)", CylinderPrimitive::fewest_facets);
  return {};
}

std::string value_text(const BoxPrimitive& box) { return extent_text(box.min, box.max); }

std::string value_text(const SpherePrimitive& sphere) {
  return fmt::format("center {}, radius {}, facets {}", text_of(sphere.center), sphere.radius, sphere.facets);
}

std::string value_text(const CylinderPrimitive& cylinder) {
  return fmt::format("{}, radius {}, facets {}", extent_text(cylinder.from, cylinder.to), cylinder.radius,
                     cylinder.facets);
}

std::string name_fault(const PrimitiveBase& primitive) {
  if (primitive.hole && !primitive.region.empty())
    return "a hole has no region; give it a `name`, or leave out `hole`";
  if (primitive.hole && primitive.name.empty()) return "a hole needs a `name` for the walls it leaves";
  if (!primitive.hole && primitive.region.empty()) return "needs a `region`, or `hole = true` with a `name`";
  return {};
}

std::string patch_fault(const Patch& patch) {
  if (!patch.min.allFinite() || !patch.max.allFinite()) return "coordinates must be finite numbers";
  if (patch.wall.empty()) return "needs a `wall`, the name that it gives";
  int flat = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (patch.min[axis] > patch.max[axis])
      return fmt::format("min must not be above max (along {})", "xyz"[axis]);
    if (patch.min[axis] == patch.max[axis]) ++flat;
  }
  if (flat != 1)
    return fmt::format(
        "min and max must agree in exactly one coordinate (a patch is a rectangle on a wall; "
        "here they agree in {})",
        flat);
  return {};
}

}  // namespace

const PrimitiveBase& base_of(const Primitive& primitive) {
  return std::visit([](const auto& shape) -> const PrimitiveBase& { return shape; }, primitive);
}

std::string text_of(const Vec3& point) {
  return fmt::format("[{}, {}, {}]", point.x(), point.y(), point.z());
}

void check_primitives(const Geometry& geometry) {
  std::vector<Fault> faults;
  bool any_region = false;
  for (const Primitive& primitive : geometry.primitives) {
    const PrimitiveBase& base = base_of(primitive);
    any_region = any_region || !base.hole;
    const auto report = [&](const std::string& problem) {
      const std::string value = std::visit([](const auto& shape) { return value_text(shape); }, primitive);
      if (!problem.empty()) faults.push_back(fault_at(base.origin, value, problem));
    };
    report(std::visit([](const auto& shape) { return shape_fault(shape); }, primitive));
    report(name_fault(base));
  }
  for (const Patch& patch : geometry.patches) {
    const std::string problem = patch_fault(patch);
    if (!problem.empty())
      faults.push_back(fault_at(patch.origin, extent_text(patch.min, patch.max), problem));
  }
  for (const Sheet& sheet : geometry.sheets) {
    const std::string problem =
        sheet.front.empty() || sheet.back.empty() ? "needs names for both sides" : sheet_fault(sheet);
    if (!problem.empty()) faults.push_back(fault_at(sheet.origin, "", problem));
  }
  if (faults.empty() && !any_region) {
    const Origin origin =
        geometry.primitives.empty() ? Origin{} : base_of(geometry.primitives.front()).origin;
    faults.push_back(fault_at(
        origin, "", "no primitive has a region (there is nothing to mesh); add a box with a region"));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

Fault patch_covers_nothing(const Patch& patch) {
  return fault_at(patch.origin, extent_text(patch.min, patch.max),
                  fmt::format("wall \"{}\" covers no boundary (nothing of the patch lies on the outside, or "
                              "later patches hide it); move it onto a wall",
                              patch.wall));
}

}  // namespace etendue
