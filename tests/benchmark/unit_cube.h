// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/problem.h"

namespace etendue {

/// The unit cube by TetGen with quality 1.4: 12k, 60k, 199k cells for 2.25e-4, 3.4e-5, 1e-5.
inline TetrahedralMesh unit_cube(double max_volume) {
  Geometry geometry;
  BoxPrimitive box;
  box.region = "cube";
  geometry.primitives.emplace_back(box);
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{max_volume}, 1.4, {}}));
}

/// Smoke in the cube, lit by grey walls that reflect.
inline Problem smoke(const TetrahedralMesh& mesh, int bands, const PhaseFunction& phase) {
  const auto count = static_cast<std::size_t>(bands);
  Bands spectrum;
  spectrum.names.clear();
  for (int b = 0; b < bands; ++b) spectrum.names.push_back("band" + std::to_string(b));
  Medium medium{"cube",
                std::vector<Coefficient>(count, Coefficient(0.5)),
                std::vector<Coefficient>(count, Coefficient(1.0)),
                std::vector<Coefficient>(count, Coefficient(1.0)),
                std::vector<PhaseFunction>(count, phase),
                {}};
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names())
    walls.push_back({name,
                     std::vector<double>(count, 0.1),
                     std::vector<double>(count, 0.3),
                     std::vector<double>(count, 0),
                     {}});
  return Problem(mesh, spectrum, {medium}, walls);
}

/// The same; `asymmetry` 0 scatters isotropically, others as Henyey and Greenstein have it.
inline Problem smoke(const TetrahedralMesh& mesh, int bands, double asymmetry) {
  if (asymmetry == 0) return smoke(mesh, bands, PhaseIsotropic{});
  return smoke(mesh, bands, PhaseHenyeyGreenstein{asymmetry});
}

}  // namespace etendue
