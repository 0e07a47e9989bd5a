// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace etendue {

/// A plane of numbers in a linear image, row by row from the top.
struct ImageChannel {
  std::string name;
  std::vector<float> values;
};

/// The bytes of an OpenEXR file: 32-bit floating point, compressed without loss. `comment` says what the
/// numbers are.
std::string exr_bytes(std::array<int, 2> pixels, const std::vector<ImageChannel>& channels,
                      const std::string& comment);

/// The bytes of a PNG file of 8 bits per primary, marked as sRGB; `rgb` is [row from the top][column][3].
std::string png_bytes(std::array<int, 2> pixels, std::span<const std::uint8_t> rgb);

}  // namespace etendue
