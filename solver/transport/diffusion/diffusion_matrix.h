// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/transport/diffusion/block_matrix.h"

namespace etendue {

/// The coefficients of diffusion in one band,
///
///     -div(D grad phi) + sigma_a phi = q,
///     a phi + n.D grad phi / 2 = alpha (a phi - n.D grad phi / 2) at a wall of reflectance alpha (Marshak
///     1947).
struct DiffusionCoefficients {
  std::vector<double> absorption;  ///< [cell] [1/length]
  /// [cell] D, symmetric and positive definite [length]; in the plane without z.
  std::vector<Eigen::Matrix3d> diffusion;
  std::vector<char> lumped;         ///< [cell] whether the mass is lumped there
  std::vector<double> reflectance;  ///< [boundary face] alpha, 0 ... 1
  double partial_current = 0.25;    ///< a: of isotropic light of fluence 1 through a plane, one way
  bool is_plane = false;            ///< whether light travels in the plane z = const alone
  bool operator==(const DiffusionCoefficients&) const = default;
};

/// Mass matrix of one cell: V/20 (1 + delta_ij), lumped V/4 delta_ij [length^3].
Eigen::Matrix4d mass_matrix(double volume, bool lumped);

/// Gradients of the four barycentric coordinates of a cell, in columns [1/length].
Eigen::Matrix<double, 3, 4> barycentric_gradients(const TetrahedralMesh& mesh, CellIndex cell);

/// Contribution of one cell to the form (D7) of docs/theory/iteration.md: absorption, diffusion, and the
/// walls that it touches. On continuous functions this is the whole form.
Eigen::Matrix4d cell_matrix(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients,
                            CellIndex cell);

/// Those of all cells.
using CellMatrices = std::vector<Eigen::Matrix4d>;
CellMatrices cell_matrices(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients);

/// The modified interior penalty form of diffusion on discontinuous linear elements (Wang and Ragusa 2010;
/// Turcksin and Ragusa 2014; docs/theory/iteration.md): symmetric, positive definite where something absorbs
/// or leaves.
BlockMatrix diffusion_matrix(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients);
/// The same where the matrices of the cells are known.
BlockMatrix diffusion_matrix(const TetrahedralMesh& mesh, const DiffusionCoefficients& coefficients,
                             const CellMatrices& matrices);

}  // namespace etendue
