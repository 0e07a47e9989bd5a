// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/toned_png.h"

#include "app/write/image/color.h"
#include "app/write/image/image_files.h"

namespace etendue {

std::vector<LinearColor> balanced(std::span<const LinearColor> colors, const WhiteBalance& white) {
  std::vector<LinearColor> result;
  result.reserve(colors.size());
  for (const LinearColor& color : colors) result.push_back(white.of(color));
  return result;
}

std::vector<std::uint8_t> toned_bytes(std::span<const LinearColor> colors, std::optional<double> exposure,
                                      Tone tone) {
  const double factor = exposure ? *exposure : automatic_exposure(colors);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * colors.size());
  for (LinearColor color : colors) {
    for (double& value : color) value *= factor;
    for (const double value : toned(color, tone)) rgb.push_back(display_value(value, Exposure{1}));
  }
  return rgb;
}

std::string toned_png(std::array<int, 2> pixels, std::span<const LinearColor> colors,
                      std::optional<double> exposure, Tone tone) {
  return png_bytes(pixels, toned_bytes(colors, exposure, tone));
}

}  // namespace etendue
