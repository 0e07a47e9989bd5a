// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "solver/angular/kernels/dense_kernel.h"
#include "solver/angular/kernels/kernel_places.h"
#include "solver/solution/balance.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

// Media whose coefficients depend on the direction, for their tests.
namespace etendue {

/// One band with a scattering law that depends on both directions.
inline Medium medium_of(DirectionalScattering scattering_law, double absorption, double scattering) {
  Medium medium = uniform_medium(1, absorption, scattering, 0);
  medium.directional = {std::move(scattering_law)};
  return medium;
}

/// The kernel of a formula.
inline DirectionalScattering kernel(const std::string& text) {
  KernelFormula formula;
  formula.formula = std::make_shared<Expression>(text, kernel_variables());
  return formula;
}

/// Walls of a column: an emitter below, a black wall above, mirrors around.
inline std::vector<Wall> column(const TetrahedralMesh& mesh) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    const bool end = name == "zmin" || name == "zmax";
    walls.push_back(uniform_wall(1, name == "zmin" ? 1 : 0, 0, end ? 0 : 1));
    walls.back().name = name;
  }
  return walls;
}

/// Expects emitted light and inflow to equal absorption and outflow, equation (15) of docs/theory/theory.md.
inline void expect_balance(const Problem& problem, const Solution& solution) {
  EXPECT_LT(std::abs(balances(problem, solution).front().residual), 1e-10);
}

/// Mean radiance of one ordinate at the upper end.
inline double mean_at_top(const TetrahedralMesh& mesh, const OrdinateRadiance& kept) {
  double top = 0, area = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (mesh.wall_names()[static_cast<std::size_t>(mesh.wall(face))] != "zmax") continue;
    const auto& of_cell = mesh.vertices(mesh.owner(face));
    for (const std::int32_t v : mesh.vertices(face)) {
      const auto node =
          static_cast<std::size_t>(std::find(of_cell.begin(), of_cell.end(), v) - of_cell.begin());
      top += mesh.area(face) / 3 * kept.values[mesh.owner(face).at() * 4 + node];
    }
    area += mesh.area(face);
  }
  return top / area;
}

}  // namespace etendue
