// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Medium, sources and inflow of one ordinate in one band.
struct ReferenceSweep {
  const TetrahedralMesh& mesh;
  Vec3 direction;                      ///< of travel, unit
  std::span<const CellIndex> order;    ///< all cells, each after its neighbors upwind
  std::span<const double> extinction;  ///< sigma_t, [cell] [1/length]
  std::span<const char> lumped;        ///< [cell] whether the mass matrix is lumped, equation (8)
  std::span<const double> source;      ///< s at the vertices, [cell][4] [power/(length^3 sr)]
  std::span<const double> inflow;  ///< [boundary face][3] radiance at the face's vertices; read where light
                                   ///< enters [power/(length^2 sr)]
};

/// Returns the radiance at the vertices of all cells along one ordinate, [cell][4] [power/(length^2 sr)].
///
/// **Read this first.** This is the method of docs/theory/theory.md without any of its speed: cell by cell
/// downwind, it assembles the four equations (5) for the radiance at the vertices of a tetrahedron, or (8)
/// where the mass is lumped, and solves them by elimination. sweep_kernel.h does the same for many cells and
/// bands side by side, with the closed form (7), and must agree to 1e-13
/// (tests/solver/transport/kernel/reference_sweep_test.cpp). A sweep repeats this for all ordinates
/// (transport_sweep.h); the iteration repeats sweeps, with the scattered and reflected light of the last one
/// as source and inflow (iteration.h).
std::vector<double> reference_sweep(const ReferenceSweep& sweep);

}  // namespace etendue
