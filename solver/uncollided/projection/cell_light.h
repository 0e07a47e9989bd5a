// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "base/quadrature/simplex_rules.h"
#include "solver/uncollided/moments/nodal_moments.h"
#include "solver/uncollided/sources/beam_source.h"
#include "solver/uncollided/sources/light_source.h"
#include "solver/uncollided/sources/point_source.h"
#include "solver/uncollided/sources/shadow_planes.h"

namespace etendue {

/// A cell as its light is integrated.
struct LitCell {
  LitCell(const LightPaths& paths, CellIndex cell);

  CellIndex index;
  std::array<Vec3, 4> corners;
  double volume;
  double size;  ///< edge of a regular tetrahedron of this volume [length]
  Vec3 centroid;
  double thickness;  ///< largest extinction times size

  Vec3 position(const std::array<double, 4>& barycentric) const {
    return barycentric[0] * corners[0] + barycentric[1] * corners[1] + barycentric[2] * corners[2] +
           barycentric[3] * corners[3];
  }
};

/// Adds the light of a point in its polar frame: with the shape functions a + b r along a direction,
///
///     integral over K of shape phi dV = P integral dw i(w) T(in) integral of (a + b r) e^(-s (r - in)) dr.
///
/// Divided along shadow planes.
void add_in_polar_frame(const LightPaths& paths, const PointSource& source, const ShadowPlanes& shadows,
                        const LitCell& cell, NodalMoments& moments);

/// Adds the light of a beam column by column, in closed form along the light, divided along shadow planes.
void add_in_columns(const LightPaths& paths, const BeamSource& source, const ShadowPlanes& shadows,
                    const LitCell& cell, NodalMoments& moments);

/// Adds the light of a point or a beam: in one of these ways, or from a few points of the cell where light is
/// even enough.
void add_directly(const LightPaths& paths, const LightSource& source, const ShadowPlanes& shadows,
                  const LitCell& cell, LightBeams& beams, NodalMoments& moments);

}  // namespace etendue
