// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "mesh/tetrahedra/search/ray_mesh.h"
#include "solver/observe/photon_map/keep_hits.h"
#include "solver/observe/photon_map/surface_hits.h"
#include "solver/observe/photon_map/volume_hits.h"
#include "solver/photons/sampling/formula_emission.h"
#include "solver/photons/solve/probe_histories.h"
#include "solver/problem/problem.h"
#include "solver/uncollided/rays/attenuation.h"
#include "solver/uncollided/rays/light_paths.h"

namespace etendue {

/// Radiance from a photon map (Jensen 2001, sections 7.2 and 10.4): hits sample the light that arrives.
///
/// A hit p brings the power dF_p in the direction w_p. Around a point of a wall those that fell on an area A,
/// and around one in a medium those that were scattered in a volume V, give
///
///     L_wall(x, w) = sum of f_r(w_p -> w) dF_p / A        [power/(length^2 sr)]    (1)
///     S(x, w)      = sum of p(w_p.w) dF_p / V             [power/(length^3 sr)] (2)
///
/// with f_r = diffuse/pi + that of the lobe, and transmittance/pi for hits on the other side of a sheet, and
/// where (2) is what scattering adds to the radiance along its path: photons are scattered at the rate
/// sigma_s times the fluence, so that Jensen's division by sigma_s, which gives a mean of radiance, and the
/// factor sigma_s of the transport equation cancel.
class MapRadiance {
 public:
  /// The problem must outlive it. Takes over the hits, [band].
  MapRadiance(const Problem& problem, std::vector<BandHits> hits, std::size_t neighbours);
  MapRadiance(const MapRadiance&) = delete;
  MapRadiance& operator=(const MapRadiance&) = delete;

  /// What one thread works with.
  struct Workspace {
    SurfaceHits::Around surface;
    VolumeHits::Around volume;
    std::vector<std::pair<CellIndex, double>> parts;  ///< cells along a ray and the lengths in them
  };

  const Problem& problem() const { return problem_; }

  // Estimates have the standard error of a sum over independent hits, the root of the sum of squares.

  /// (1) without what the wall emits and mirrors.
  Estimate reflected(FaceIndex face, const Vec3& point, const Vec3& travel, int band, Workspace& work) const;
  /// (2) of light that continues in the direction `travel`; the ball's radius is left in the workspace, 0
  /// where there is none.
  Estimate scattered(CellIndex cell, const Vec3& point, const Vec3& travel, int band, Workspace& work) const;
  /// Irradiance of a wall [power/length^2]: (1) with 1 in place of f_r.
  Estimate irradiance(FaceIndex face, const Vec3& point, int band, Workspace& work) const;

  /// The radiance that arrives at `start` from where the unit vector `direction` points. The ray is followed
  /// through mirrors; between them it gathers emission and (2) with the extinction of the cells, and at walls
  /// what they emit and (1).
  double along(const PointInCell& start, const Vec3& direction, int band, Workspace& work) const;

 private:
  struct RaySegment;
  /// Sum of share(hit) over the hits on an area around a point, over the area.
  template <class Share>
  Estimate on_wall(FaceIndex face, const Vec3& point, int band, Workspace& work, const Share& share) const;
  void add_matter(const RaySegment& segment, Workspace& work, double& radiance, double& left) const;
  double add_flat_lights(const RaySegment& segment, double length, const Workspace& work) const;
  double emitted_along(CellIndex cell, const RaySegment& segment, double from, double length,
                       const AttenuationIntegrals& integrals) const;
  double march(const RaySegment& segment, std::size_t first, std::size_t last, double begin,
               Workspace& work) const;
  /// Radiance that a wall emits at a point of a face.
  double emitted(FaceIndex face, const Vec3& point, const Vec3& travel, int band) const;
  double extinction(CellIndex cell, int band) const {
    return problem_.absorption(cell, band) + problem_.scattering(cell, band);
  }

  const Problem& problem_;
  std::vector<BandHits> hits_;
  RayMesh rays_;
  WallPlanes planes_;
  std::vector<std::unique_ptr<const FormulaEmitter>> formulas_;  ///< [wall][band] of radiance; null: none
  std::vector<std::int32_t> behind_;   ///< [boundary face] other side of a sheet, -1: none
  std::vector<SurfaceHits> surfaces_;  ///< [band]
  std::vector<VolumeHits> volumes_;    ///< [band]
};

}  // namespace etendue
