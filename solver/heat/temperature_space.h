// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/heat/heat_problem.h"

namespace etendue {

/// The unknowns: of media that conduct the temperature T at each vertex, which cells around it share that are
/// joined there by faces (so not those on the two sides of a sheet); of others, four numbers in each cell,
/// which may jump from cell to cell as the fluence does, and are those of T^4/T_0^3. Where the fluence of
/// linear elements falls below zero, so do these: what is absorbed is given back.
class TemperatureSpace {
 public:
  /// Throws InputError where a conductivity is negative or not finite.
  TemperatureSpace(const TetrahedralMesh& mesh, const HeatProblem& heat);

  std::size_t size() const { return size_; }
  /// [unknown] Temperatures [K] of values of the unknowns [K]; below zero where these are.
  std::vector<double> temperatures(std::span<const double> values) const;
  bool is_vertex(std::size_t unknown) const { return unknown < vertex_unknowns_; }
  double usual_temperature() const { return usual_; }  ///< T_0 [K]
  /// Of vertex i of a cell; -1: none.
  std::int32_t unknown(CellIndex cell, std::size_t i) const { return unknowns_[4 * cell.at() + i]; }
  bool has(CellIndex cell) const { return unknown(cell, 0) >= 0; }
  bool conducts(CellIndex cell) const { return conductivity_[cell.at()] > 0; }
  double conductivity(CellIndex cell) const { return conductivity_[cell.at()]; }  ///< mean [W/(m K)]
  /// Number of the first unknowns, those of vertices.
  std::size_t vertex_unknowns() const { return vertex_unknowns_; }

 private:
  std::vector<double> conductivity_;    ///< [cell] 0 where none
  std::vector<std::int32_t> unknowns_;  ///< [cell][4]
  std::size_t vertex_unknowns_ = 0;
  std::size_t size_ = 0;
  double usual_;
};

}  // namespace etendue
