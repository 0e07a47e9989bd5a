// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "base/parallel/rank_group.h"
#include "base/parallel/stage_observer.h"
#include "solver/uncollided/moments/collision_field.h"
#include "solver/uncollided/moments/glossy_beams.h"
#include "solver/uncollided/sources/light_source.h"

namespace etendue {

/// Uncollided light of all sources on the mesh: projections on the functions that are linear in each cell and
/// on each boundary face.
struct UncollidedField {
  std::vector<double> fluence;     ///< [cell][4][band] [power/length^2]
  std::vector<double> net_flux;    ///< [cell][4][3][band]
  std::vector<double> irradiance;  ///< [boundary face][3][band]
  CollisionField collisions;       ///< what scatters by direction, and from where it comes
  GlossyBeams glossy;              ///< the directions of the light at glossy walls
  // Where something in the problem depends on the direction of light or varies in cells; else empty, and both
  // are coefficients times fluence.
  std::vector<double> collided;  ///< [cell][4][band] [power/length^3]
  std::vector<double> absorbed;  ///< [cell][band] [power/length^3]
};

/// Power density that scatters at entry [cell][4][band] of a field [power/length^3].
double scattered_density(const Problem& problem, const UncollidedField& field, std::size_t entry);

/// Integrates the light of the sources: of a point in its polar frame, where the distance squared cancels, of
/// a beam in columns along it, both in closed form along the path through a cell and cut along the edges of
/// shadows (ShadowPlanes), or by four points where it is even; of a light with an extent by its attenuation
/// on the paths to the vertices (ExtendedLight). The same bits for any number of threads. An observer that
/// stops it leaves the field incomplete. `ranks` are processes that share cells and faces and all get the
/// whole field; null: this one alone.
UncollidedField uncollided_field(const LightPaths& paths, const LightSources& sources, int threads,
                                 const StageObserver& observer = {}, RankGroup* ranks = nullptr);

using SourceViews = std::vector<const LightSource*>;

/// The same of some sources, without glossy walls. `incident` are the directions of the collisions; null:
/// those of these sources.
UncollidedField uncollided_field(const LightPaths& paths, const SourceViews& sources,
                                 std::shared_ptr<const IncidentDirections> incident, int threads,
                                 const StageObserver& observer = {}, RankGroup* ranks = nullptr);

}  // namespace etendue
