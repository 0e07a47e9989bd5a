// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/photons/kernel/photon_scene.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"

namespace etendue {

/// What the histories of one band left, before it is a field.
class TallySums {
 public:
  explicit TallySums(const TetrahedralMesh& mesh)
      : cells_(16 * static_cast<std::size_t>(mesh.cell_count())),
        faces_(4 * static_cast<std::size_t>(mesh.boundary_face_count())),
        absorbed_(static_cast<std::size_t>(mesh.cell_count())) {}

  void clear();
  PhotonTally view() { return {cells_.data(), faces_.data(), absorbed_.data()}; }

  /// The P1 fields whose moments in each cell and face are `scale` times the sums, in one band of a solution:
  /// fluence, net flux and irradiance; the exitance is what is reflected by the angle, even on each face, and
  /// what is absorbed even in each cell. The
  /// inverse of the mass matrix V/20 (1 + delta_ij) of a tetrahedron is 20/V (delta_ij - 1/5), that of A/12
  /// (1 + delta_ij) of a triangle is 12/A (delta_ij - 1/4).
  void to_fields(const Problem& problem, int band, double scale, Solution& fields) const;

 private:
  std::vector<double> cells_;     ///< [cell][1, wx, wy, wz][4]
  std::vector<double> faces_;     ///< [boundary face][4]
  std::vector<double> absorbed_;  ///< [cell]
};

/// A solution with zeros in its fields; what is absorbed is one where a medium depends on the direction.
Solution empty_fields(const Problem& problem);

/// What a solution by photons has beside its fields, so that all measures can be taken of it: half ranges,
/// what beams and lights send, and to the exitance what is emitted, and what is reflected and transmitted of
/// the irradiance whatever the angle.
void complete_fields(const Problem& problem, Solution& fields);

}  // namespace etendue
