// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/lights/light.h"

namespace etendue {

/// Cosine to a face from which on a beam comes in by it.
inline constexpr double least_cosine = 1e-9;

/// The glazing [band] of a wall, null where it is an opening.
const std::vector<Glazing>* glazing_of(const Case& input, const std::string& wall);

/// The faces of a wall look one way: the normal into the domain; empty where they do not.
std::optional<Vec3> normal_of_wall(const TetrahedralMesh& mesh, int wall);

/// Walls by which light comes in alike: openings, whose `glazing` is null, or flat walls that look one way
/// and have the same glazing.
struct EntryWalls {
  const std::vector<Glazing>* glazing;
  Vec3 inwards;  ///< unit, of glazing
  std::vector<int> walls;
};

/// The walls of a light, sorted by how it comes in by them. Reports glazed walls that are not flat.
std::vector<EntryWalls> entry_walls(const LightCase& light, const std::vector<int>& walls, const Case& input,
                                    const TetrahedralMesh& mesh, std::vector<Fault>& faults);

/// What glazing leaves of a beam; empty where the beam comes from the other side.
std::optional<BeamLight> behind_glazing(BeamLight beam, const EntryWalls& entry);

}  // namespace etendue
