// SPDX-License-Identifier: AGPL-3.0-or-later
// A cube of six tetrahedra from arrays, filled with a gas that emits and absorbs, between cold black walls.
#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <etendue/etendue.h>

namespace {

constexpr const char* gas = R"toml(
title = "A hot gas in a cube of cold black walls"
[media.gas]
absorption = 1.0        # [1/m]
power_density = 4.0     # [W/m^3]
[walls.boundary]
[directions]
order = 1
)toml";

/// Corner c of the unit cube is (c & 1, c >> 1 & 1, c >> 2); each tetrahedron goes along edges from corner 0
/// to corner 7.
etendue::Mesh cube() {
  std::vector<double> points;
  for (int corner = 0; corner < 8; ++corner)
    for (const int axis : {0, 1, 2}) points.push_back(corner >> axis & 1);
  const std::array<std::int32_t, 24> tetrahedra = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7,
                                                   0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};
  etendue::MeshArrays arrays;
  arrays.points = points;
  arrays.tetrahedra = tetrahedra;
  arrays.region_names = {"gas"};
  return etendue::Mesh::from_arrays(arrays);
}

}  // namespace

int main() {
  const etendue::Mesh mesh = cube();
  const etendue::Solution solution = etendue::solve(etendue::Case::from_text(gas, mesh), mesh);
  const std::span<const double> fluence = solution.fluence();  // [cell][4 vertices][band]
  std::printf("%zu values of fluence in %d cells\n", fluence.size(), mesh.cell_count());
  std::printf("in the middle: %.6g W/m^2\n", solution.fluence_at(std::array{0.5, 0.5, 0.5}).front());
  const etendue::BandBalance balance = solution.balances().front();
  std::printf("emitted %.6g W, absorbed %.6g W, on the walls %.6g W\n", balance.emitted, balance.absorbed,
              balance.outflow);
  return solution.converged() ? 0 : 1;
}
