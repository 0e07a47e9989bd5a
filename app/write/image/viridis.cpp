// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/viridis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace etendue {
namespace {

// Every fifteenth entry of _viridis_data in colormaps.py of github.com/BIDS/colormap (CC0).
constexpr std::array<std::array<double, 3>, 18> viridis_table = {{{0.267004, 0.004874, 0.329415},
                                                                  {0.281924, 0.089666, 0.412415},
                                                                  {0.280255, 0.165693, 0.476498},
                                                                  {0.263663, 0.237631, 0.518762},
                                                                  {0.237441, 0.305202, 0.541921},
                                                                  {0.208623, 0.367752, 0.552675},
                                                                  {0.182256, 0.426184, 0.557120},
                                                                  {0.159194, 0.482237, 0.558073},
                                                                  {0.137770, 0.537492, 0.554906},
                                                                  {0.121148, 0.592739, 0.544641},
                                                                  {0.128087, 0.647749, 0.523491},
                                                                  {0.180653, 0.701402, 0.488189},
                                                                  {0.274149, 0.751988, 0.436601},
                                                                  {0.395174, 0.797475, 0.367757},
                                                                  {0.535621, 0.835785, 0.281908},
                                                                  {0.688944, 0.865448, 0.182725},
                                                                  {0.845561, 0.887322, 0.099702},
                                                                  {0.993248, 0.906157, 0.143936}}};

}  // namespace

std::array<std::uint8_t, 3> viridis(double value) {
  const double place = std::clamp(value, 0.0, 1.0) * static_cast<double>(viridis_table.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), viridis_table.size() - 2);
  const double part = place - static_cast<double>(below);
  std::array<std::uint8_t, 3> color{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double mixed = (1 - part) * viridis_table[below][i] + part * viridis_table[below + 1][i];
    color[i] = static_cast<std::uint8_t>(std::lround(255 * mixed));
  }
  return color;
}

}  // namespace etendue
