// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace etendue::test {

/// A box of air with a corner at the origin, as written in a case file.
struct BoxOfAir {
  std::string size = "[1, 1, 1]";
  double edge_length = 1;
  std::string walls = "";                     ///< names of its sides, e.g. zmax = "roof"
  std::string bands = "names = [\"light\"]";  ///< keys of [bands]
  int order = 2;                              ///< of the product set of directions
};

/// A case of such a box with a product set of directions and its results in results/. `more` are the other
/// tables: media, but for the air, walls, lights, sensors.
std::string box_case(const BoxOfAir& box, const std::string& more);

}  // namespace etendue::test
