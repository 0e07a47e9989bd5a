// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/patches/patch_neighbours.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "mesh/tetrahedra/adjacency/flat_neighbours.h"

namespace etendue {
namespace {

// Distance beyond an edge at which the neighbour is found, relative to that of the corner opposite: far less
// than the quarters of any piece, far more than rounding.
constexpr double beyond_an_edge = 1e-4;

using Weights = std::array<double, 3>;

/// Parts of the area that a point in the plane of a triangle cuts off, negative outside.
Weights weights_in(const TriangleCorners& t, const Vec3& point) {
  const Vec3 whole = (t[1] - t[0]).cross(t[2] - t[0]);
  Weights weights;
  for (std::size_t i = 0; i < 3; ++i)
    weights[i] = (t[(i + 1) % 3] - point).cross(t[(i + 2) % 3] - point).dot(whole) / whole.squaredNorm();
  return weights;
}

/// In which quarter a point lies, and where there.
std::size_t descend(Weights& w) {
  for (std::size_t i = 0; i < 3; ++i)
    if (w[i] > 0.5) {
      for (double& weight : w) weight *= 2;
      w[i] -= 1;
      return i;
    }
  w = {1 - 2 * w[2], 1 - 2 * w[0], 1 - 2 * w[1]};
  return 3;
}

bool is_finer(std::uint64_t quarters, std::uint64_t than) {
  return std::bit_width(quarters) > std::bit_width(than);
}

class PatchFinder {
 public:
  PatchFinder(const TetrahedralMesh& mesh, const WallPatches& patches)
      : mesh_(mesh), beyond_(flat_neighbours(mesh)), parts_(patches.of_faces) {
    for (std::vector<FacePart>& parts : parts_) std::ranges::sort(parts, {}, &FacePart::quarters);
  }

  /// The piece at a point just beyond an edge of a piece; none across edges between planes and feet of
  /// sheets.
  std::optional<FacePart> at(std::int32_t face, const Vec3& point) const {
    const TriangleCorners corners = inward_triangle(mesh_, FaceIndex(face));
    const Weights weights = weights_in(corners, point);
    const auto least = static_cast<std::size_t>(std::ranges::min_element(weights) - weights.begin());
    if (weights[least] >= 0) return in_face(face, weights);
    const auto& vertices = mesh_.vertices(FaceIndex(face));
    for (std::size_t i = 0; i < 3; ++i) {
      if (mesh_.point(VertexIndex(vertices[i])) != corners[least]) continue;
      const std::int32_t next = beyond_[static_cast<std::size_t>(face)][i];
      if (next < 0) return std::nullopt;
      return in_face(next, weights_in(inward_triangle(mesh_, FaceIndex(next)), point));
    }
    return std::nullopt;
  }

 private:
  std::optional<FacePart> in_face(std::int32_t face, Weights weights) const {
    const std::vector<FacePart>& parts = parts_[static_cast<std::size_t>(face)];
    const std::uint64_t deepest = parts.back().quarters;
    for (std::uint64_t quarters = 1; quarters <= deepest; quarters = 4 * quarters + descend(weights)) {
      const auto part = std::ranges::lower_bound(parts, quarters, {}, &FacePart::quarters);
      if (part != parts.end() && part->quarters == quarters) return *part;
    }
    return std::nullopt;
  }

  const TetrahedralMesh& mesh_;
  std::vector<std::array<std::int32_t, 3>> beyond_;
  std::vector<std::vector<FacePart>> parts_;  ///< [boundary face] by their quarters
};

}  // namespace

// The smaller of two pieces that share a part of an edge finds the larger one beyond the middle of its own.
std::vector<std::vector<std::size_t>> patch_neighbours(const TetrahedralMesh& mesh,
                                                       const WallPatches& patches) {
  const PatchFinder finder(mesh, patches);
  std::vector<std::vector<std::size_t>> neighbours(patches.patches.size());
  for (std::size_t p = 0; p < patches.patches.size(); ++p)
    for (const PatchPiece& piece : patches.pieces[p])
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 middle = (piece.corners[(i + 1) % 3] + piece.corners[(i + 2) % 3]) / 2;
        const auto found = finder.at(piece.face, middle + beyond_an_edge * (middle - piece.corners[i]));
        if (!found || found->patch == p || is_finer(found->quarters, piece.quarters)) continue;
        neighbours[p].push_back(found->patch);
        neighbours[found->patch].push_back(p);
      }
  for (std::vector<std::size_t>& all : neighbours) {
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  return neighbours;
}

}  // namespace etendue
