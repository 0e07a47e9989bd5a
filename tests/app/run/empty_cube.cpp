// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/app/run/empty_cube.h"

namespace etendue::test {

std::string empty_cube() {
  return R"(title = "Empty"
[mesh]
edge_length = 0.5
[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [1, 1, 1]
walls = { zmin = "floor" }
[bands]
names = ["red", "green"]
[media.air]
[walls.floor]
radiance = [1, 0.5]
diffuse = 0.2
[walls."*"]
diffuse = [0.8, 0.3]
[solve]
method = "radiosity"
tolerance = 1e-8
[[probe]]
name = "up"
points = [[0.5, 0.5, 0.5], [0.5, 0.5, 0]]
normal = [0, 0, -1]
)";
}

}  // namespace etendue::test
