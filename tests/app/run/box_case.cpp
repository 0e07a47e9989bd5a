// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/app/run/box_case.h"

#include <fmt/format.h>

namespace etendue::test {

std::string box_case(const BoxOfAir& box, const std::string& more) {
  return fmt::format(R"([mesh]
edge_length = {}
[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = {}
walls = {{ {} }}
[bands]
{}
[media.air]
[directions]
set = "product"
order = {}
[output]
directory = "results"
)",
                     box.edge_length, box.size, box.walls, box.bands, box.order) +
         more;
}

}  // namespace etendue::test
