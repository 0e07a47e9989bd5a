// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/band_color.h"

#include <algorithm>

#include "solver/observe/color/color_matching.h"

namespace etendue {
namespace {

// From the chromaticities of BT.709 and D65 (x = 0.3127, y = 0.3290); IEC 61966-2-1 rounds it.
constexpr double xyz_to_rgb[3][3] = {{3.240969942, -1.537383178, -0.4986107603},
                                     {-0.9692436363, 1.875967502, 0.04155505741},
                                     {0.0556300797, -0.2039769589, 1.056971514}};

/// Returns whether the eye sees one of them.
bool is_seen(const std::vector<LinearColor>& colors) {
  return std::ranges::any_of(colors, [](const LinearColor& color) { return color != LinearColor{}; });
}

}  // namespace

LinearColor linear_srgb(const std::array<double, 3>& xyz) {
  LinearColor color{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) color[i] += xyz_to_rgb[i][k] * xyz[k];
  return color;
}

bool are_primaries(const Bands& bands) {
  return bands.names == std::vector<std::string>{"red", "green", "blue"};
}

BandColor::BandColor(const Bands& bands) {
  const std::size_t count = bands.names.size();
  if (are_primaries(bands)) {
    of_band_ = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    rule_ = "bands red, green, blue as the primaries of sRGB";
    return;
  }
  for (std::size_t b = 0; b + 1 < bands.edges.size(); ++b)
    of_band_.push_back(linear_srgb(mean_color_matching(bands.edges[b], bands.edges[b + 1])));
  if (is_seen(of_band_)) {
    rule_ = "spectrum seen by the CIE 1931 observer, in linear sRGB";
    return;
  }
  const double share = 1 / static_cast<double>(count);
  of_band_.assign(count, {share, share, share});
  rule_ =
      bands.edges.empty() ? "grey: mean of the bands" : "grey: mean of the bands, which the eye does not see";
}

LinearColor BandColor::of(std::span<const double> radiance) const {
  LinearColor color{};
  for (std::size_t b = 0; b < of_band_.size(); ++b)
    for (std::size_t i = 0; i < 3; ++i) color[i] += of_band_[b][i] * radiance[b];
  return color;
}

double luminance(const LinearColor& color) {
  // The middle row of the inverse of xyz_to_rgb; they sum to 1, so that grey keeps its value.
  constexpr double red = 0.2126390059, green = 0.7151686788, blue = 1 - red - green;
  return red * color[0] + green * color[1] + blue * color[2];
}

}  // namespace etendue
