// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/mesh/geometry/scene.h"

#include "mesh/geometry/arrangement/arrangement.h"

namespace etendue {
namespace {

template <class Shape>
Shape filled(const std::string& region, const std::string& key) {
  Shape shape;
  shape.region = region;
  shape.origin = {"case.toml", 7, key};
  return shape;
}

template <class Shape>
Shape as_hole(Shape shape, const std::string& name) {
  shape.region.clear();
  shape.hole = true;
  shape.name = name;
  return shape;
}

}  // namespace

BoxPrimitive box(const std::string& region, const Vec3& min, const Vec3& max) {
  auto primitive = filled<BoxPrimitive>(region, "mesh.box");
  primitive.min = min;
  primitive.max = max;
  return primitive;
}

BoxPrimitive box_hole(const std::string& name, const Vec3& min, const Vec3& max) {
  return as_hole(box("", min, max), name);
}

BoxPrimitive named(BoxPrimitive primitive, const std::map<std::string, std::string>& walls) {
  primitive.walls = walls;
  return primitive;
}

SpherePrimitive sphere(const std::string& region, const Vec3& center, double radius, int facets) {
  auto primitive = filled<SpherePrimitive>(region, "mesh.sphere");
  primitive.center = center;
  primitive.radius = radius;
  primitive.facets = facets;
  return primitive;
}

SpherePrimitive sphere_hole(const std::string& name, const Vec3& center, double radius, int facets) {
  return as_hole(sphere("", center, radius, facets), name);
}

CylinderPrimitive cylinder(const std::string& region, const Vec3& from, const Vec3& to, double radius,
                           int facets) {
  auto primitive = filled<CylinderPrimitive>(region, "mesh.cylinder");
  primitive.from = from;
  primitive.to = to;
  primitive.radius = radius;
  primitive.facets = facets;
  return primitive;
}

CylinderPrimitive cylinder_hole(const std::string& name, const Vec3& from, const Vec3& to, double radius,
                                int facets) {
  return as_hole(cylinder("", from, to, radius, facets), name);
}

Patch patch(const std::string& wall, const Vec3& min, const Vec3& max) {
  return {wall, min, max, {"case.toml", 30, "mesh.patch"}};
}

std::string fault_of(const Geometry& geometry) {
  try {
    arrange(geometry);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

}  // namespace etendue
