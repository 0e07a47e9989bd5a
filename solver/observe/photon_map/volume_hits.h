// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/tetrahedra/search/ray_mesh.h"
#include "solver/observe/photon_map/hit_tree.h"
#include "solver/observe/photon_map/keep_hits.h"

namespace etendue {

/// Hits in media in one band and what they say of the light that is scattered there.
class VolumeHits {
 public:
  /// The arguments must outlive it.
  VolumeHits(const TetrahedralMesh& mesh, const RayMesh& rays, std::size_t neighbours, const KeptHits& kept);

  /// The hits around a point of a cell, and the volume that they lie in.
  struct Around {
    NearHits near;
    std::vector<std::uint32_t> hits;
    double volume = 0;  ///< [length^3]
    double radius = 0;  ///< [length]
  };
  /// Those of the nearest hits that are seen from the point through its region alone, and how much of the
  /// ball around them is seen so: neither walls nor the ends of a medium darken the estimate. False without
  /// any hits.
  bool around(CellIndex cell, const Vec3& point, Around& found) const;

  const PhotonHit& hit(std::uint32_t number) const { return kept_.hits[number]; }
  double power() const { return kept_.power; }  ///< of a hit of weight 1

 private:
  /// How much of a ball is seen from its middle through the region alone [length^3].
  double volume_seen(CellIndex cell, const Vec3& point, double radius) const;
  double path_in_region(CellIndex cell, const Vec3& point, const Vec3& direction, double length) const;

  const TetrahedralMesh& mesh_;
  const RayMesh& rays_;
  std::size_t neighbours_;
  const KeptHits& kept_;
  std::optional<HitTree> tree_;
};

}  // namespace etendue
