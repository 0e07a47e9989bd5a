// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/sheet_triangles.h"

#include "base/position.h"
#include "mesh/geometry/arrangement/facet_triangles.h"
#include "mesh/geometry/primitives/sheet_shape.h"

namespace etendue {
namespace {}  // namespace

std::vector<SheetTriangle> sheet_triangles(const Sheet& sheet, int number) {
  const Vec3 normal = sheet_normal(sheet);
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const int count = static_cast<int>(sheet.corners.size());
  std::vector<ExactPoint> points;
  for (const Vec3& corner : sheet.corners) points.push_back(exact(corner));
  std::vector<std::array<int, 2>> edges;
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    edges.push_back(normal[axis] > 0 ? std::array{i, next} : std::array{next, i});
  }
  std::vector<SheetTriangle> triangles;
  for (const auto& [a, b, c] :
       facet_triangles(edges, {}, axis, [&](int i) -> const ExactPoint& { return points[position(i)]; }))
    triangles.push_back({{points[position(a)], points[position(b)], points[position(c)]},
                         ExactPlane(points[position(a)], points[position(b)], points[position(c)]),
                         number});
  return triangles;
}

}  // namespace etendue
