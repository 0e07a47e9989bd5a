// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/space_filling_curve.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "mesh/tetrahedra/bounding_box.h"

namespace etendue {
namespace {

constexpr int kBits = 21;  // three times 21 bits fit into one key

/// From coordinates to the "transpose" of the key: its bits dealt out to three words (Skilling 2004).
void axes_to_transpose(std::array<std::uint32_t, 3>& x) {
  for (std::uint32_t q = 1u << (kBits - 1); q > 1; q >>= 1) {
    const std::uint32_t low = q - 1;
    for (auto& word : x) {
      if (word & q) {
        x[0] ^= low;
      } else {
        const std::uint32_t swapped = (x[0] ^ word) & low;
        x[0] ^= swapped;
        word ^= swapped;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t flips = 0;
  for (std::uint32_t q = 1u << (kBits - 1); q > 1; q >>= 1)
    if (x[2] & q) flips ^= q - 1;
  for (auto& word : x) word ^= flips;
}

}  // namespace

std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  std::array<std::uint32_t, 3> words{x, y, z};
  axes_to_transpose(words);
  std::uint64_t key = 0;
  for (int bit = kBits - 1; bit >= 0; --bit)
    for (const auto word : words) key = (key << 1) | ((word >> bit) & 1u);
  return key;
}

std::vector<std::int32_t> curve_order(std::span<const Vec3> points) {
  std::vector<std::int32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  if (points.empty()) return order;
  const auto [low, high] = bounding_box(points);
  const double side = (high - low).maxCoeff();
  const double scale = side > 0 ? ((1u << kBits) - 1) / side : 0;
  std::vector<std::uint64_t> keys;
  keys.reserve(points.size());
  for (const Vec3& p : points) {
    const Vec3 lattice = (p - low) * scale;
    keys.push_back(hilbert_key(static_cast<std::uint32_t>(lattice.x()),
                               static_cast<std::uint32_t>(lattice.y()),
                               static_cast<std::uint32_t>(lattice.z())));
  }
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return keys[static_cast<std::size_t>(a)] < keys[static_cast<std::size_t>(b)];
  });
  return order;
}

}  // namespace etendue
