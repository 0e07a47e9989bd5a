// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/heat/heat_problem.h"
#include "solver/problem/problem.h"

namespace etendue {

/// The unknowns: of media that conduct the temperature T at each vertex, which cells around it share that are
/// joined there by faces (so not those on the two sides of a sheet); of other media four numbers in each
/// cell, and of walls three in each face, which may jump from one to the next as light does. Those of cells
/// are T^4/T_0^3 (in steps in time (T^4 + T_0^3 T)/(2 T_0^3)), those of walls (a T^4 + b T)/(a T_0^3 + b):
/// what they give away by radiation, convection and conduction, in which their balance is linear but for the
/// shares of bands. Where the light of linear elements falls below zero, so do these: what is absorbed is
/// given back.
class TemperatureSpace {
 public:
  /// Throws InputError where a conductivity is negative or not finite.
  /// The problem need not outlive it.
  TemperatureSpace(const Problem& problem, const HeatProblem& heat);

  std::size_t size() const { return size_; }
  /// [unknown] Temperatures [K] of values of the unknowns [K]; below zero where these are.
  std::vector<double> temperatures(std::span<const double> values) const;
  /// Whether it is a temperature itself, of a vertex.
  bool is_temperature(std::size_t unknown) const { return unknown < vertex_unknowns_; }
  /// The value of an unknown at a temperature, below zero where that is.
  double value(std::size_t unknown, double kelvin) const;
  /// Changes of T and of T^4 of an unknown with its value, at a temperature [K].
  double kelvin_per_value(std::size_t unknown, double kelvin) const;
  double power_per_value(std::size_t unknown, double kelvin) const;
  double usual_temperature() const { return usual_; }  ///< T_0 [K]
  /// Of vertex i of a cell; -1: none.
  std::int32_t unknown(CellIndex cell, std::size_t i) const { return unknowns_[4 * cell.at() + i]; }
  bool has(CellIndex cell) const { return unknown(cell, 0) >= 0; }
  /// Of vertex i of a boundary face; -1: none.
  std::int32_t unknown(FaceIndex face, std::size_t i) const { return of_walls_[3 * face.at() + i]; }
  bool has(FaceIndex face) const { return unknown(face, 0) >= 0; }
  /// A conductivity that depends on the temperature may be 0 at the usual one.
  bool conducts(CellIndex cell) const { return conducts_[cell.at()] != 0; }
  /// Mean at the usual temperature [W/(m K)].
  double conductivity(CellIndex cell) const { return conductivity_[cell.at()]; }
  /// Number of the first unknowns, those of vertices and walls.
  std::size_t unknowns_before_cells() const { return unknowns_before_cells_; }

 private:
  /// Heat that is given away, a T^4 + b T.
  struct Loss {
    double radiation;  ///< a [W/(m^2 K^4)]
    double linear;     ///< b [W/(m^2 K)]
  };
  Loss loss(std::size_t unknown) const;
  void number_vertices(const TetrahedralMesh& mesh);
  void number_cells(const TetrahedralMesh& mesh, const HeatProblem& heat);
  void number_walls(const Problem& problem, const HeatProblem& heat);
  double temperature(std::size_t unknown, double value) const;

  std::vector<double> conductivity_;    ///< [cell] 0 where none
  std::vector<char> conducts_;          ///< [cell]
  std::vector<std::int32_t> unknowns_;  ///< [cell][4]
  std::vector<std::int32_t> of_walls_;  ///< [boundary face][3]
  std::vector<Loss> losses_;            ///< [unknown of a wall]
  std::size_t vertex_unknowns_ = 0;
  std::size_t unknowns_before_cells_ = 0;
  std::size_t size_ = 0;
  double usual_;
  double stored_;  ///< b of cells [K^3]: what holds heat gives it away by the kelvin too
};

}  // namespace etendue
