// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/quadrature/collapsed_rule.h"
#include "solver/uncollided/projection/cell_light.h"
#include "solver/uncollided/sources/extended_source.h"
#include "solver/uncollided/visibility/occluding_edges.h"
#include "solver/uncollided/visibility/vertex_attenuation.h"

namespace etendue {

/// Light of a source with an extent in cells and on walls. The light through a homogeneous medium needs no
/// rays: it is integrated as finely as it varies. Rays traced to the vertices and edges of the mesh
/// (VertexAttenuation) give the effective extinction of that medium and the visible fraction; near a surface
/// that shines, rays go to points of the cell itself; in shadows, and at the edge of a cloud, to each point
/// of the rule. In the
/// penumbra of a flat light each point sees it cut along the edges that hide a part of it, in cells where the
/// light has few triangles, and faces are divided until that changes little. In a homogeneous medium nothing
/// is left to be interpolated.
class ExtendedLight {
 public:
  ExtendedLight(const LightPaths& paths, const ExtendedSource& source,
                const std::vector<ShadowEdge>& shadow_edges, int threads, RankGroup* ranks = nullptr);

  void add(const LitCell& cell, LightBeams& beams, NodalMoments& moments) const;
  void add(FaceIndex face, LightBeams& beams, NodalMoments& moments) const;

 private:
  template <std::size_t corners>
  struct Site;
  struct Arrived;

  /// How often a cell near the light is divided at most.
  int divisions_of(const LitCell& cell) const;
  void arrive(const Vec3& place, std::span<const PathAttenuation> attenuation, LightBeams& beams,
              Arrived& light) const;
  /// False where a point is in the shadow, or all are behind the light.
  template <std::size_t corners>
  bool sample_inside(const Site<corners>& site, LightBeams& beams,
                     InterpolatedAttenuation<corners>& interpolated) const;
  /// Of a part of a cell or a face.
  template <std::size_t corners>
  SteepCorners<corners> steep_corners(const Site<corners>& site,
                                      const std::array<std::array<double, corners>, corners>& part) const;
  template <std::size_t corners, class Deposit>
  void add_lit(const Site<corners>& site, const InterpolatedAttenuation<corners>& interpolated, int divisions,
               const Deposit& deposit, LightBeams& beams, NodalMoments& moments) const;
  template <std::size_t corners, class Deposit>
  void add_point_by_point(const Site<corners>& site,
                          const std::array<std::array<double, corners>, corners>& part, double measure,
                          int divisions, const LightDetail& detail, const Deposit& deposit, LightBeams& beams,
                          NodalMoments& moments) const;
  /// Adaptively, on both sides of the plane of the light.
  template <std::size_t corners, class AddPoint>
  void integrate(const Site<corners>& site, double tolerance, int divisions, const AddPoint& add_point,
                 NodalMoments& moments) const;
  /// A cell near a light in one plane, or a face before which edges hide a part of it: each point by rays to
  /// the light.
  template <std::size_t corners, class Deposit>
  void add_along_rays(const Site<corners>& site, const LightDetail& detail, double tolerance, int divisions,
                      const Deposit& deposit, LightBeams& beams, NodalMoments& moments) const;
  template <std::size_t corners, class Deposit>
  void add(const Site<corners>& site, const std::array<std::int32_t, corners>& vertices,
           const std::vector<ShadowEdge>& edges, int divisions, const Deposit& deposit, LightBeams& beams,
           NodalMoments& moments) const;

  const LightPaths& paths_;
  const ExtendedSource& source_;
  std::size_t bands_;
  VertexAttenuation vertex_attenuation_;
  OccludingEdges edges_;
};

}  // namespace etendue
