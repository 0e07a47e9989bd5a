// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "mesh/geometry/primitives/geometry.h"

namespace etendue {

// Primitives as the case file gives them: those with a region fill it, holes have a name. All of them come
// from line 7 of case.toml, patches from line 30.

BoxPrimitive box(const std::string& region, const Vec3& min, const Vec3& max);
BoxPrimitive box_hole(const std::string& name, const Vec3& min, const Vec3& max);
BoxPrimitive named(BoxPrimitive primitive, const std::map<std::string, std::string>& walls);

SpherePrimitive sphere(const std::string& region, const Vec3& center, double radius, int facets = 320);
SpherePrimitive sphere_hole(const std::string& name, const Vec3& center, double radius, int facets = 320);
CylinderPrimitive cylinder(const std::string& region, const Vec3& from, const Vec3& to, double radius,
                           int facets = 32);
CylinderPrimitive cylinder_hole(const std::string& name, const Vec3& from, const Vec3& to, double radius,
                                int facets = 32);

Patch patch(const std::string& wall, const Vec3& min, const Vec3& max);

/// What `arrange` says against a scene.
std::string fault_of(const Geometry& geometry);

}  // namespace etendue
