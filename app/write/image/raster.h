// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace etendue {

using RgbColor = std::array<std::uint8_t, 3>;

/// A picture of 8 bits per primary that things are drawn into; dots outside of it are lost.
class Raster {
 public:
  Raster(int across, int down, RgbColor background);

  int across() const { return across_; }
  int down() const { return down_; }
  void set(int column, int row, RgbColor color);
  void fill(int column, int row, int width, int height, RgbColor color);
  /// Characters of 5 x 7 dots, each a square of `scale` pixels, from their upper left corner.
  void write(int column, int row, std::string_view text, int scale, RgbColor color);
  /// [row][column][3]
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  int across_, down_;
  std::vector<std::uint8_t> bytes_;
};

/// Size of a text in pixels.
int text_width(std::string_view text, int scale);
int text_height(int scale);

}  // namespace etendue
