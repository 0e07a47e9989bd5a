// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/raster.h"

#include <algorithm>
#include <cstddef>

#include "app/write/image/dot_font.h"

namespace etendue {

Raster::Raster(int across, int down, RgbColor background) : across_(across), down_(down) {
  bytes_.reserve(3 * static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
  for (int i = 0; i < across * down; ++i) bytes_.insert(bytes_.end(), background.begin(), background.end());
}

void Raster::set(int column, int row, RgbColor color) {
  if (column < 0 || row < 0 || column >= across_ || row >= down_) return;
  const auto at = 3 * (static_cast<std::ptrdiff_t>(row) * across_ + column);
  std::ranges::copy(color, bytes_.begin() + at);
}

void Raster::fill(int column, int row, int width, int height, RgbColor color) {
  for (int y = row; y < row + height; ++y)
    for (int x = column; x < column + width; ++x) set(x, y, color);
}

void Raster::write(int column, int row, std::string_view text, int scale, RgbColor color) {
  for (const char character : text) {
    const auto& dots = dots_of(character);
    for (int x = 0; x < dot_columns; ++x)
      for (int y = 0; y < dot_rows; ++y)
        if ((dots[static_cast<std::size_t>(x)] >> y & 1) != 0)
          fill(column + x * scale, row + y * scale, scale, scale, color);
    column += (dot_columns + 1) * scale;
  }
}

int text_width(std::string_view text, int scale) {
  return static_cast<int>(text.size()) * (dot_columns + 1) * scale;
}

int text_height(int scale) { return dot_rows * scale; }

}  // namespace etendue
