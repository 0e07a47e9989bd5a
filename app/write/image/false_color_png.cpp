// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/false_color_png.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/write/image/color_scale.h"
#include "app/write/image/image_files.h"
#include "app/write/image/raster.h"
#include "app/write/image/viridis.h"

namespace etendue {
namespace {

constexpr RgbColor white = {255, 255, 255}, black = {0, 0, 0}, grey = {128, 128, 128};

/// Of a logarithmic scale that does not say where it begins.
constexpr double decades = 1e-3;

/// A picture so high has characters of single pixels; of a multiple they are larger.
constexpr int height_of_small_text = 400;

ColorScale scale_of(const FalseColor& wanted, std::span<const double> values) {
  double most = 0;
  for (const double value : values)
    if (std::isfinite(value)) most = std::max(most, value);
  most = wanted.most.value_or(most);
  double least = wanted.least.value_or(wanted.logarithmic ? most * decades : 0);
  // Of a dark picture, or one below what the scale begins with.
  if (!(most > least)) most = least > 0 ? 2 * least : 1;
  if (wanted.logarithmic && least == 0) least = most * decades;
  return {least, most, wanted.logarithmic};
}

/// Lengths in units of a dot of the text.
constexpr int margin = 6, bar_width = 12, tick_length = 3, least_height = 160;

struct Layout {
  int scale;         ///< pixels of a dot of the text
  int panel;         ///< width of the scale, with its margins [pixel]
  int bar_row;       ///< [pixel]
  int bar_height;    ///< [pixel]
  int total_height;  ///< [pixel]
};

Layout layout_of(std::array<int, 2> pixels, const std::vector<ColorScale::Tick>& ticks,
                 const std::string& title) {
  const int scale = std::max(1, pixels[1] / height_of_small_text);
  int width = 0;
  for (const ColorScale::Tick& tick : ticks) width = std::max(width, text_width(tick.label, scale));
  width += (bar_width + 2 * tick_length) * scale;
  const int height = std::max(pixels[1], least_height * scale);
  const int bar_row = 2 * margin * scale + text_height(scale);
  return {scale, 2 * margin * scale + std::max(width, text_width(title, scale)), bar_row,
          height - bar_row - margin * scale - text_height(scale), height};
}

void draw_scale(int column, const Layout& layout, const std::vector<ColorScale::Tick>& ticks,
                const std::string& title, Raster& raster) {
  const int scale = layout.scale, left = column + margin * scale;
  raster.write(left, margin * scale, title, scale, black);
  const int rows = layout.bar_height;
  for (int row = 0; row < rows; ++row)
    raster.fill(left, layout.bar_row + row, bar_width * scale, 1, viridis(1 - (row + 0.5) / rows));
  for (const ColorScale::Tick& tick : ticks) {
    const int row = layout.bar_row + static_cast<int>(std::lround((1 - tick.place) * (rows - 1)));
    raster.fill(left + bar_width * scale, row, tick_length * scale, scale, black);
    raster.write(left + (bar_width + 2 * tick_length) * scale, row - text_height(scale) / 2, tick.label,
                 scale, black);
  }
}

}  // namespace

std::string false_color_png(std::array<int, 2> pixels, std::span<const double> values,
                            const FalseColor& scale, const std::string& title) {
  const ColorScale colors = scale_of(scale, values);
  const std::vector<ColorScale::Tick> ticks = colors.ticks();
  const Layout layout = layout_of(pixels, ticks, title);
  Raster raster(pixels[0] + layout.panel, layout.total_height, white);
  for (int row = 0; row < pixels[1]; ++row)
    for (int column = 0; column < pixels[0]; ++column) {
      const double value = values[static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels[0]) +
                                  static_cast<std::size_t>(column)];
      raster.set(column, row, std::isnan(value) ? grey : viridis(colors.place_of(value)));
    }
  draw_scale(pixels[0], layout, ticks, title, raster);
  return png_bytes({raster.across(), raster.down()}, raster.bytes());
}

}  // namespace etendue
