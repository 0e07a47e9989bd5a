// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/solve/sheet_passages.h"

#include <algorithm>
#include <map>
#include <utility>

#include "mesh/tetrahedra/sheet_faces.h"

namespace etendue {
namespace {

/// A piece of a face, and the patch that it is of.
struct Part {
  std::size_t patch;
  const TriangleCorners* corners;
};

double triangle_area(const TriangleCorners& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2; }

/// Returns whether the point, which lies in the plane of the triangle, is inside.
bool contains(const TriangleCorners& t, const Vec3& point) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  for (std::size_t i = 0; i < 3; ++i)
    if ((t[(i + 1) % 3] - t[i]).cross(point - t[i]).dot(normal) < 0) return false;
  return true;
}

/// Pieces of one face are quarters of quarters: of two that meet, one lies in the other.
double common_area(const TriangleCorners& a, const TriangleCorners& b) {
  const double area_a = triangle_area(a), area_b = triangle_area(b);
  const TriangleCorners &small = area_a < area_b ? a : b, &large = area_a < area_b ? b : a;
  return contains(large, (small[0] + small[1] + small[2]) / 3) ? std::min(area_a, area_b) : 0;
}

}  // namespace

std::vector<SheetPassage> sheet_passages(const TetrahedralMesh& mesh, const WallPatches& patches) {
  const std::vector<std::int32_t> behind = faces_behind(mesh);
  std::vector<std::vector<Part>> parts(behind.size());
  for (std::size_t p = 0; p < patches.pieces.size(); ++p)
    for (const PatchPiece& piece : patches.pieces[p])
      parts[static_cast<std::size_t>(piece.face)].push_back({p, &piece.corners});
  std::map<std::pair<std::size_t, std::size_t>, double> common;  // area by patches from and to
  for (std::size_t f = 0; f < behind.size(); ++f) {
    if (behind[f] < 0) continue;
    for (const Part& to : parts[f])
      for (const Part& from : parts[static_cast<std::size_t>(behind[f])])
        if (const double area = common_area(*from.corners, *to.corners); area > 0)
          common[{from.patch, to.patch}] += area;
  }
  std::vector<SheetPassage> passages;
  for (const auto& [pair, area] : common)
    passages.push_back({pair.first, pair.second, area / patches.patches[pair.second].area()});
  return passages;
}

}  // namespace etendue
