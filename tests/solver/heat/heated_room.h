// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/heat/heat_problem.h"
#include "solver/problem/band_blackbody.h"
#include "solver/problem/problem.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::heated_room {

/// Walls of temperatures by their names, the same emissivity everywhere.
struct Room {
  const TetrahedralMesh& mesh;
  Bands bands;
  Medium medium;
  double emissivity = 1;
  std::vector<double> wall_temperatures = {};  ///< [wall]
  double conductivity = 0;
  double source = 0;
  bool walls_follow = false;  ///< their temperatures, so that they emit nothing by themselves

  Problem problem() const {
    std::vector<Wall> walls;
    for (std::size_t w = 0; w < mesh.wall_names().size(); ++w) {
      Wall wall = uniform_wall(bands.count(), 0, 1 - emissivity, 0);
      wall.name = mesh.wall_names()[w];
      wall.emission_follows = walls_follow;
      for (int b = 0; b < bands.count() && !walls_follow; ++b)
        wall.radiance[static_cast<std::size_t>(b)] =
            emissivity * band_blackbody(bands, b, wall_temperatures[w]);
      walls.push_back(wall);
    }
    std::vector<Medium> media(mesh.region_names().size(), medium);
    return Problem(mesh, bands, media, walls);
  }

  HeatProblem heat() const {
    HeatProblem heat;
    heat.media.assign(mesh.region_names().size(), HeatMedium{conductivity, source});
    for (const double kelvin : wall_temperatures) heat.wall_temperatures.emplace_back(Coefficient(kelvin));
    heat.walls.resize(wall_temperatures.size());
    return heat;
  }
};

/// Temperatures of walls, of which one is zmax.
inline std::vector<double> walls_of(const TetrahedralMesh& mesh, double kelvin, double top) {
  std::vector<double> walls;
  for (const std::string& name : mesh.wall_names()) walls.push_back(name == "zmax" ? top : kelvin);
  return walls;
}

}  // namespace etendue::heated_room
