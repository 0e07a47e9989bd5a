// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/patches/wall_patches.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "base/field_view.h"
#include "mesh/tetrahedra/adjacency/flat_neighbours.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

constexpr std::int32_t nowhere = -1;

double longest_side(const TriangleCorners& t) {
  return std::sqrt(
      std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()}));
}

/// The square of a grid in the plane of a triangle that its centre lies in.
std::array<long, 2> square_of(const TriangleCorners& t, double size) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  Eigen::Index across = 0;
  normal.cwiseAbs().maxCoeff(&across);
  const Vec3 u = Vec3::Unit((across + 1) % 3).cross(normal).normalized(), v = normal.cross(u);
  const Vec3 center = (t[0] + t[1] + t[2]) / 3;
  return {std::lround(std::floor(center.dot(u) / size)), std::lround(std::floor(center.dot(v) / size))};
}

/// Of its face's area.
double share_of(const PatchPiece& piece) {
  const int halvings_of_sides = (std::bit_width(piece.quarters) - 1) / 2;
  return std::ldexp(1.0, -2 * halvings_of_sides);
}

/// Makes patches out of triangles.
class PatchMaker {
 public:
  explicit PatchMaker(const TetrahedralMesh& mesh)
      : mesh_(mesh),
        beyond_(flat_neighbours(mesh)),
        place_(static_cast<std::size_t>(mesh.boundary_face_count()), nowhere) {
    result_.of_faces.resize(place_.size());
  }

  /// All of them as one patch.
  void add(std::vector<PatchPiece> pieces, double size) {
    std::vector<TriangleCorners> triangles;
    for (const PatchPiece& piece : pieces) {
      triangles.push_back(piece.corners);
      result_.of_faces[static_cast<std::size_t>(piece.face)].push_back(
          {result_.patches.size(), share_of(piece), piece.quarters});
    }
    result_.patches.emplace_back(std::move(triangles));
    result_.walls.push_back(mesh_.wall(FaceIndex(pieces.front().face)));
    result_.sizes.push_back(size);
    result_.pieces.push_back(std::move(pieces));
  }

  /// Cut and joined to a size.
  void add_to_size(std::span<const PatchPiece> pieces, double size) {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (pieces[i].quarters == 1 && longest_side(pieces[i].corners) <= size)
        place_[static_cast<std::size_t>(pieces[i].face)] = static_cast<std::int32_t>(i);
    for (const PatchPiece& piece : pieces) {
      if (longest_side(piece.corners) > size)
        add_quarters(piece, size);
      else if (piece.quarters != 1)
        add({piece}, size);
      else if (place_[static_cast<std::size_t>(piece.face)] != nowhere)
        add(taken_around(piece, pieces, size), size);
    }
  }

  WallPatches take() { return std::move(result_); }

 private:
  void add_quarters(const PatchPiece& piece, double size) {
    if (longest_side(piece.corners) <= size) return add({piece}, size);
    for (std::size_t q = 0; q < 4; ++q)
      add_quarters({piece.face, 4 * piece.quarters + q, quarter_of(piece.corners, q)}, size);
  }

  /// A face that has a place among the pieces, and from there on those in its square beyond edges. They lose
  /// their places.
  std::vector<PatchPiece> taken_around(const PatchPiece& first, std::span<const PatchPiece> pieces,
                                       double size) {
    place_[static_cast<std::size_t>(first.face)] = nowhere;
    std::vector<PatchPiece> patch = {first};
    const auto square = square_of(first.corners, size);
    for (std::size_t i = 0; i < patch.size(); ++i)
      for (const std::int32_t next : beyond_[static_cast<std::size_t>(patch[i].face)]) {
        const std::int32_t place = next < 0 ? nowhere : place_[static_cast<std::size_t>(next)];
        if (place == nowhere || mesh_.wall(FaceIndex(next)) != mesh_.wall(FaceIndex(first.face))) continue;
        const PatchPiece& piece = pieces[static_cast<std::size_t>(place)];
        if (square_of(piece.corners, size) != square) continue;
        place_[static_cast<std::size_t>(next)] = nowhere;
        patch.push_back(piece);
      }
    return patch;
  }

  const TetrahedralMesh& mesh_;
  std::vector<std::array<std::int32_t, 3>> beyond_;
  std::vector<std::int32_t> place_;  ///< [boundary face] among the pieces, of those to be joined
  WallPatches result_;
};

}  // namespace

TriangleCorners inward_triangle(const TetrahedralMesh& mesh, FaceIndex face) {
  TriangleCorners t = corners_of(mesh, face);
  if ((t[1] - t[0]).cross(t[2] - t[0]).dot(mesh.area_normal(face)) > 0) std::swap(t[1], t[2]);
  return t;
}

TriangleCorners quarter_of(const TriangleCorners& t, std::size_t quarter) {
  const Vec3 ab = (t[0] + t[1]) / 2, bc = (t[1] + t[2]) / 2, ca = (t[2] + t[0]) / 2;
  const std::array<TriangleCorners, 4> quarters = {
      {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}}};
  return quarters[quarter];
}

WallPatches wall_patches(const TetrahedralMesh& mesh, double size) {
  std::vector<PatchPiece> faces;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    faces.push_back({f, 1, inward_triangle(mesh, FaceIndex(f))});
  PatchMaker maker(mesh);
  if (size > 0)
    maker.add_to_size(faces, size);
  else
    for (const PatchPiece& face : faces) maker.add({face}, longest_side(face.corners));
  return maker.take();
}

WallPatches refined_patches(const TetrahedralMesh& mesh, const WallPatches& patches,
                            const std::vector<bool>& cut) {
  PatchMaker maker(mesh);
  for (std::size_t p = 0; p < patches.patches.size(); ++p) {
    if (cut[p])
      maker.add_to_size(patches.pieces[p], patches.sizes[p] / 2);
    else
      maker.add(patches.pieces[p], patches.sizes[p]);
  }
  return maker.take();
}

std::vector<double> means_at_vertices(const TetrahedralMesh& mesh, const WallPatches& patches,
                                      const std::vector<double>& values, std::size_t bands) {
  std::vector<double> means(patches.of_faces.size() * 3 * bands, 0);
  const FaceField at_vertices(means, bands);
  const ConstBandTable of_patches(values, bands);
  for (std::size_t p = 0; p < patches.pieces.size(); ++p)
    for (const PatchPiece& piece : patches.pieces[p]) {
      const FaceIndex face(piece.face);
      const Vec3 middle = (piece.corners[0] + piece.corners[1] + piece.corners[2]) / 3;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 to = corner_of(mesh, face, (i + 1) % 3) - middle;
        const Vec3 and_to = corner_of(mesh, face, (i + 2) % 3) - middle;
        const double weight = to.cross(and_to).norm() / (2 * mesh.area(face));
        for (std::size_t b = 0; b < bands; ++b)
          at_vertices(face, i, b) += 3 * share_of(piece) * weight * of_patches(p, b);
      }
    }
  return means;
}

std::vector<TriangleCorners> triangles_of(const std::vector<FlatPatch>& patches) {
  std::vector<TriangleCorners> triangles;
  for (const FlatPatch& patch : patches)
    triangles.insert(triangles.end(), patch.triangles().begin(), patch.triangles().end());
  return triangles;
}

}  // namespace etendue
