// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "solver/photons/solve/solve_photons.h"
#include "solver/radiosity/solve/solve_radiosity.h"
#include "solver/solution/balance.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue {

struct Surface {
  double radiance = 0, diffuse = 0, transmittance = 0, specular = 0;
};

/// Walls by name, the rest like `other`.
Problem room(const TetrahedralMesh& mesh, const Medium& medium, const std::map<std::string, Surface>& named,
             const Surface& other = {}, std::vector<Light> lights = {});

Solution by_ordinates(const Problem& problem);
Solution by_radiosity(const Problem& problem, RadiosityMethod method = RadiosityMethod::gathering,
                      double patch_size = 0);
/// `derived` holds what arrives at each wall.
PhotonSolution by_photons(const Problem& problem, double photons);

std::size_t wall_number(const Problem& problem, const std::string& wall);
WallPower power_on(const Problem& problem, const Solution& solution, const std::string& wall);

}  // namespace etendue
