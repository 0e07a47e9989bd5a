// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "base/errors.h"
#include "base/vec3.h"

namespace etendue {

/// What every primitive has. A hole removes its volume; its surface becomes walls that begin with `name`.
struct PrimitiveBase {
  std::string region;  ///< name of the region that fills it; empty for a hole
  bool hole = false;
  std::string name;  ///< of a hole
  Origin origin;
};

/// An axis-aligned box. `walls` names sides ("xmin" … "zmax") that end up on the outside.
struct BoxPrimitive : PrimitiveBase {
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Ones();
  std::map<std::string, std::string> walls;
};

/// A ball, approximated from inside by a polyhedron of about `facets` triangles.
struct SpherePrimitive : PrimitiveBase {
  static constexpr int fewest_facets = 20;  ///< of the icosahedron
  Vec3 center = Vec3::Zero();
  double radius = 1;
  int facets = 320;
};

/// A straight round cylinder from the middle of one end to the middle of the other; `facets` sides.
struct CylinderPrimitive : PrimitiveBase {
  static constexpr int fewest_facets = 3;  ///< sides of a prism
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::UnitZ();
  double radius = 1;
  int facets = 32;
};

using Primitive = std::variant<BoxPrimitive, SpherePrimitive, CylinderPrimitive>;

/// An axis-aligned rectangle (min and max agree in one coordinate) on the outside that gets its own wall
/// name.
struct Patch {
  std::string wall;
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Zero();
  Origin origin;
};

/// An opaque plane polygon inside the domain. Where it lies on the outside or in a hole it is nothing.
struct Sheet {
  std::vector<Vec3> corners;  ///< in order; the front is the side from which they turn counterclockwise
  std::string front;          ///< wall names of the two sides
  std::string back;
  Origin origin;
};

/// A scene of primitives in the order of the file: where they overlap, the later one counts.
struct Geometry {
  std::vector<Primitive> primitives;
  std::vector<Patch> patches;
  std::vector<Sheet> sheets = {};
  double snap = 1e-9;  ///< part of the longest side within which coordinates are made equal
};

}  // namespace etendue
