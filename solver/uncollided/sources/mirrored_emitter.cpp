// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/sources/mirrored_emitter.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace etendue {
namespace {

/// More faces make too many pairs of a face in front and one behind.
constexpr std::size_t most_faces = 12;

/// Corners so near to a plane, in sizes of the body, lie in it.
constexpr double corner_in_plane = 1e-9;

/// Of each vertex of the mesh, whether it is in the plane of a mirror.
std::vector<char> vertices_of(const LightPaths& paths, int plane) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  std::vector<char> on_plane(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (const FaceIndex face(f); paths.mirrors().of(face) == plane)
      for (const std::int32_t vertex : mesh.vertices(face)) on_plane[static_cast<std::size_t>(vertex)] = 1;
  return on_plane;
}

/// Returns whether all that meets the plane here comes back.
bool sends_all_back(const LightPaths& paths, std::int32_t face, int plane) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  if (face >= mesh.boundary_face_count() || paths.mirrors().of(FaceIndex(face)) != plane) return false;
  const std::vector<double>& specular = paths.problem().wall(mesh.wall(FaceIndex(face))).specular;
  return std::ranges::all_of(specular, [](double r) { return r == 1; });
}

/// Returns whether the cells have faces in a plane, nothing behind it, and all of those faces send all light
/// back.
bool touches_whole(const LightPaths& paths, std::span<const EmitterPart> cells, int plane) {
  const MirrorSet mirror = MirrorSet{1} << plane;
  Eigen::AlignedBox3d box;
  for (const EmitterPart& cell : cells)
    for (const Vec3& corner : cell.corners) box.extend(corner);
  const double distance = corner_in_plane * box.diagonal().norm();
  bool any = false;
  for (const EmitterPart& cell : cells) {
    unsigned off = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (paths.mirrors().behind(mirror, cell.corners[i], distance) != 0) return false;
      if (!paths.mirrors().touches(mirror, cell.corners[i], distance)) off |= 1U << i;
    }
    // The face opposite the only corner that does not lie in the plane.
    if (std::popcount(off) != 1) continue;
    const auto k = static_cast<std::size_t>(std::countr_zero(off));
    if (!sends_all_back(paths, paths.problem().mesh().faces(*cell.cell)[k], plane)) return false;
    any = true;
  }
  return any;
}

/// The tetrahedra and their images behind a mirror. Vertices in its plane stay where they are, to the last
/// bit, so that what meets there has the same corners.
std::vector<EmitterPart> with_images(const LightPaths& paths, std::vector<EmitterPart> tetrahedra,
                                     int plane) {
  const std::vector<char> on_plane = vertices_of(paths, plane);
  const std::size_t count = tetrahedra.size();
  for (std::size_t t = 0; t < count; ++t) {
    EmitterPart image = tetrahedra[t];
    const auto& vertices = paths.problem().mesh().vertices(*image.cell);
    for (std::size_t i = 0; i < 4; ++i)
      if (on_plane[static_cast<std::size_t>(vertices[i])] == 0)
        image.corners[i] = paths.mirrors().image(MirrorSet{1} << plane, image.corners[i]);
    tetrahedra.push_back(std::move(image));
  }
  return tetrahedra;
}

}  // namespace

MirrorSet mirrors_touched(const LightPaths& paths, std::span<const EmitterPart> cells) {
  MirrorSet touched = 0;
  for (int plane = 0; plane < paths.mirrors().count(); ++plane) {
    // Where a plane has several mirrors one of them counts for what is seen behind it.
    bool all = true;
    for (std::size_t b = 0; b < paths.bands(); ++b)
      all = all && paths.mirrors().reflectance(MirrorSet{1} << plane, b) == 1;
    if (all && touches_whole(paths, cells, plane)) touched |= MirrorSet{1} << plane;
  }
  return touched;
}

MirroredEmitter::MirroredEmitter(std::span<const EmitterPart> tetrahedra) : shapes(solid_shapes(tetrahedra)) {
  if (shapes.size() == 1) convex = shapes[0].first.convex_faces();
  if (convex.size() > most_faces) convex.clear();
  for (const EmitterPart& part : tetrahedra)
    for (const Vec3& corner : part.corners) box.extend(corner);
  for (const EmitterPart& part : tetrahedra)
    for (const Vec3& corner : part.corners) radius = std::max(radius, (corner - box.center()).norm());
}

MirroredEmitter::MirroredEmitter(const LightPaths& paths, std::span<const EmitterPart> cells,
                                 MirrorSet mirrors)
    : MirroredEmitter(cells) {
  std::vector<EmitterPart> tetrahedra(cells.begin(), cells.end());
  for (int plane = 0; plane < paths.mirrors().count() && !shapes.empty(); ++plane) {
    if ((mirrors >> plane & 1) == 0) continue;
    std::vector<EmitterPart> more = with_images(paths, tetrahedra, plane);
    MirroredEmitter mirrored{more};
    if (mirrored.shapes.empty() || (mirrored.convex.empty() && !convex.empty())) continue;
    mirrored.across = across | MirrorSet{1} << plane;
    *this = std::move(mirrored);
    tetrahedra = std::move(more);
  }
}

}  // namespace etendue
