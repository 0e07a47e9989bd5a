// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "base/parallel/rank_group.h"
#include "base/parallel/stage_observer.h"
#include "solver/uncollided/projection/cell_light.h"
#include "solver/uncollided/sources/sky_source.h"

namespace etendue {

/// Light of a sky in the cells, beam by beam. Rays go to the vertices of the mesh; between them the optical
/// depth of each beam is linear, as it is in a homogeneous medium behind a flat wall, and so is the part of
/// the cell that it comes to. Cells at sheets, whose vertices see another light from each side, are sampled
/// from points.
///
/// `begin` is called with the moments of a cell before light is added to them. `add` is called with the
/// integrals over a cell (with what is absorbed and scatters where a medium depends on directions or
/// varies in cells), several times for each cell, each of several beams, and by several threads at a time for
/// different cells. The counter counts sky_visits() parts and may stop it.
void add_sky_light(const LightPaths& paths, const SkySource& sky, const RankShare& own, int threads,
                   StageCounter& counter, const std::function<void(const LitCell&, NodalMoments&)>& begin,
                   const std::function<void(const LitCell&, const NodalMoments&)>& add);

/// How often add_sky_light() comes to a vertex or a cell.
std::size_t sky_visits(const TetrahedralMesh& mesh, const SkySource& sky);

}  // namespace etendue
