// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/open_walls.h"

#include <algorithm>

#include "mesh/tetrahedra/search/outer_walls.h"

namespace etendue {
namespace {

bool is_bare(const Wall& wall) {
  const auto zero = [](const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double v) { return v == 0; });
  };
  return zero(wall.radiance) && zero(wall.diffuse) && zero(wall.specular) && !wall.is_glossy() &&
         !wall.transmits() && !wall.emission_follows;
}

}  // namespace

std::vector<int> open_walls(const TetrahedralMesh& mesh, std::span<const Wall> walls) {
  const std::vector<bool> outer = outer_walls(mesh);
  std::vector<int> numbers;
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (outer[w] && is_bare(walls[w])) numbers.push_back(static_cast<int>(w));
  return numbers;
}

}  // namespace etendue
