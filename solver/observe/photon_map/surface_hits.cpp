// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/surface_hits.h"

#include <algorithm>
#include <numeric>

#include "base/segment.h"
#include "mesh/tetrahedra/adjacency/flat_neighbours.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/observe/photon_map/disc_area.h"

namespace etendue {

WallPlanes::WallPlanes(const TetrahedralMesh& mesh)
    : beyond(flat_neighbours(mesh)), plane(beyond.size(), -1) {
  std::vector<std::int32_t> waiting;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (plane[static_cast<std::size_t>(f)] >= 0) continue;
    const auto number = static_cast<std::int32_t>(area.size());
    area.push_back(0);
    plane[static_cast<std::size_t>(f)] = number;
    waiting = {f};
    while (!waiting.empty()) {
      const FaceIndex face(waiting.back());
      waiting.pop_back();
      area.back() += mesh.area(face);
      for (const std::int32_t next : beyond[face.at()])
        if (next >= 0 && plane[static_cast<std::size_t>(next)] < 0) {
          plane[static_cast<std::size_t>(next)] = number;
          waiting.push_back(next);
        }
    }
  }
}

SurfaceHits::SurfaceHits(const TetrahedralMesh& mesh, const WallPlanes& planes, std::size_t neighbours,
                         KeptHits& kept)
    : mesh_(mesh), planes_(planes), neighbours_(neighbours), kept_(kept), first_(planes.area.size() + 1, 0) {
  const auto plane_of = [&](const PhotonHit& hit) {
    return planes.plane[static_cast<std::size_t>(hit.place)];
  };
  std::ranges::stable_sort(kept.hits, {}, plane_of);
  for (const PhotonHit& hit : kept.hits) ++first_[static_cast<std::size_t>(plane_of(hit)) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (std::size_t p = 0; p < planes.area.size(); ++p) {
    const std::span<const PhotonHit> hits = hits_of(static_cast<std::int32_t>(p));
    trees_.push_back(hits.size() > neighbours ? std::make_unique<HitTree>(hits) : nullptr);
  }
}

std::span<const PhotonHit> SurfaceHits::hits_of(std::int32_t plane) const {
  const auto p = static_cast<std::size_t>(plane);
  return std::span(kept_.hits).subspan(first_[p], first_[p + 1] - first_[p]);
}

void SurfaceHits::around(FaceIndex face, const Vec3& point, Around& found) const {
  const auto plane = static_cast<std::size_t>(planes_.plane[face.at()]);
  const auto first = static_cast<std::uint32_t>(first_[plane]);
  found.hits.clear();
  if (trees_[plane] == nullptr) {
    found.area = planes_.area[plane];
    for (std::size_t i = first_[plane]; i < first_[plane + 1]; ++i)
      found.hits.push_back(static_cast<std::uint32_t>(i));
    return;
  }
  trees_[plane]->nearest(point, neighbours_, found.near);
  add_faces_in_disc(face, point, found.near.radius, found);
  for (const std::uint32_t near : found.near.number)
    if (std::ranges::find(found.faces, kept_.hits[first + near].place) != found.faces.end())
      found.hits.push_back(first + near);
}

void SurfaceHits::add_faces_in_disc(FaceIndex start, const Vec3& point, double radius, Around& found) const {
  found.faces = {start.value()};
  found.area = 0;
  for (std::size_t i = 0; i < found.faces.size(); ++i) {
    const FaceIndex face(found.faces[i]);
    const std::array<Vec3, 3> corners = corners_of(mesh_, face);
    found.area += area_in_disc(corners, point, radius);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t next = planes_.beyond[face.at()][k];
      if (next < 0 || std::ranges::find(found.faces, next) != found.faces.end()) continue;
      if (distance_to_segment(point, corners[(k + 1) % 3], corners[(k + 2) % 3]) < radius)
        found.faces.push_back(next);
    }
  }
}

}  // namespace etendue
