// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/random/random_stream.h"

namespace etendue {

/// Points that fill the unit cube of so many dimensions evenly, begun somewhere (Cranley and Patterson 1976):
/// steps of 1/g, 1/g^2, …, where g^(n+1) = g + 1 in n dimensions (Roberts 2018).
template <std::size_t dimensions>
class EvenPoints {
 public:
  /// Each number of each use begins elsewhere.
  explicit EvenPoints(std::uint64_t number, RandomUse use = RandomUse::form_factor) {
    RandomStream stream(0, number, use);
    std::uint32_t word[4];
    for (std::size_t i = 0; i < dimensions; ++i) {
      if (i % 4 == 0) stream.next(word);
      place_[i] = uniform(word[i % 4]);
    }
  }

  const std::array<double, dimensions>& next() {
    for (std::size_t i = 0; i < dimensions; ++i) {
      place_[i] += step[i];
      place_[i] -= std::floor(place_[i]);
    }
    return place_;
  }

 private:
  static constexpr std::array<double, dimensions> steps() {
    double g = 1.5;
    for (int i = 0; i < 30; ++i) {  // Newton's method for g^(n+1) - g - 1
      double power = 1;
      for (std::size_t k = 0; k < dimensions; ++k) power *= g;
      g -= (power * g - g - 1) / (static_cast<double>(dimensions + 1) * power - 1);
    }
    std::array<double, dimensions> result{};
    double part = 1;
    for (double& one : result) one = part /= g;
    return result;
  }
  static constexpr std::array<double, dimensions> step = steps();

  std::array<double, dimensions> place_{};
};

}  // namespace etendue
