// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/observe/photon_map/hit_tree.h"
#include "solver/observe/photon_map/keep_hits.h"

namespace etendue {

/// The boundary faces that flat_neighbours() joins, plane by plane.
struct WallPlanes {
  explicit WallPlanes(const TetrahedralMesh& mesh);

  std::vector<std::array<std::int32_t, 3>> beyond;  ///< [boundary face] as of flat_neighbours()
  std::vector<std::int32_t> plane;                  ///< [boundary face]
  std::vector<double> area;                         ///< [plane] [length^2]
};

/// Hits on walls in one band and what they say of the light that arrives there.
class SurfaceHits {
 public:
  /// The arguments must outlive it. Sorts the hits.
  SurfaceHits(const TetrahedralMesh& mesh, const WallPlanes& planes, std::size_t neighbours, KeptHits& kept);

  /// The hits around a point of a face, and the area that they fell on.
  struct Around {
    NearHits near;
    std::vector<std::int32_t> faces;  ///< that the area is made of
    std::vector<std::uint32_t> hits;  ///< on these
    double area = 0;                  ///< [length^2]
  };
  /// Those of the nearest hits that lie in the part of the disc around them that can be reached from the
  /// point within the plane, and the area of that part: nothing darkens towards the edges of a wall, and what
  /// falls on the other side of a sheet does not count. Where a plane has no more hits than are asked for,
  /// all of it.
  void around(FaceIndex face, const Vec3& point, Around& found) const;

  const PhotonHit& hit(std::uint32_t number) const { return kept_.hits[number]; }
  double power() const { return kept_.power; }  ///< of a hit of weight 1

 private:
  void add_faces_in_disc(FaceIndex face, const Vec3& point, double radius, Around& found) const;
  std::span<const PhotonHit> hits_of(std::int32_t plane) const;

  const TetrahedralMesh& mesh_;
  const WallPlanes& planes_;
  std::size_t neighbours_;
  const KeptHits& kept_;
  std::vector<std::size_t> first_;               ///< [plane + 1] of its hits
  std::vector<std::unique_ptr<HitTree>> trees_;  ///< [plane] where it has more hits than are asked for
};

}  // namespace etendue
