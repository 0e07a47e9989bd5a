// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "base/position.h"
#include "mesh/geometry/arrangement/plane_arrangement.h"

namespace etendue {
namespace {

/// The same plane with the largest component of its normal positive, so that dropping that coordinate keeps
/// orientation.
FacePlane oriented(const ExactPlane& plane) {
  const Vec3 normal =
      Vec3(CGAL::to_double(plane.a()), CGAL::to_double(plane.b()), CGAL::to_double(plane.c())).normalized();
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  if (normal[axis] > 0) return {plane, normal, axis, {}};
  return {plane.opposite(), -normal, axis, {}};
}

bool lies_in(const ConvexBody& body, int face, const FacePlane& plane, const Vec3& normal) {
  constexpr double kParallel = 1e-9;  // a cheap filter before the exact test
  if ((normal - plane.normal).cwiseAbs().maxCoeff() > kParallel) return false;
  for (int i = 0; i < 3; ++i)
    if (!plane.plane.has_on(body.points[position(body.faces[position(face)][position(i)])])) return false;
  return true;
}

}  // namespace

std::vector<FacePlane> face_planes(const BodyScene& scene) {
  std::vector<FacePlane> planes;
  for (int b = 0; b < static_cast<int>(scene.bodies.size()); ++b) {
    const ConvexBody& body = scene.bodies[position(b)];
    for (int f = 0; f < static_cast<int>(body.faces.size()); ++f) {
      const FacePlane own = oriented(body.planes[position(f)]);
      auto same = std::find_if(planes.begin(), planes.end(),
                               [&](const FacePlane& plane) { return lies_in(body, f, plane, own.normal); });
      if (same == planes.end()) same = planes.insert(planes.end(), own);
      same->faces.push_back({b, f});
    }
  }
  for (const SheetTriangle& triangle : scene.sheets) {
    const auto holds = [&](const FacePlane& plane) {
      return std::all_of(triangle.corners.begin(), triangle.corners.end(),
                         [&](const ExactPoint& corner) { return plane.plane.has_on(corner); });
    };
    if (std::none_of(planes.begin(), planes.end(), holds)) planes.push_back(oriented(triangle.plane));
  }
  return planes;
}

}  // namespace etendue
