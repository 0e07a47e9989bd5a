// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

#include "base/random/philox.h"

namespace etendue {

/// What random numbers are drawn for; different uses of one history never share numbers.
enum class RandomUse : std::uint32_t {
  emission = 0,
  flight = 1,
  reverse = 2,
  lattice = 3,
  form_factor = 4,
  path = 5,
  path_start = 6
};

/// The random numbers of one history, four at a time: the same whichever thread walks it.
class RandomStream {
 public:
  ETENDUE_PHOTON_MEMBER RandomStream(std::uint64_t seed, std::uint64_t history, RandomUse use)
      : seed_(seed), history_(history), use_(static_cast<std::uint32_t>(use)) {}

  ETENDUE_PHOTON_MEMBER void next(std::uint32_t (&word)[4]) {
    word[0] = static_cast<std::uint32_t>(history_);
    word[1] = static_cast<std::uint32_t>(history_ >> 32);
    word[2] = event_++;
    word[3] = use_;
    philox4x32(word, static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32));
  }

  ETENDUE_PHOTON_MEMBER std::uint64_t seed() const { return seed_; }
  ETENDUE_PHOTON_MEMBER std::uint64_t history() const { return history_; }
  ETENDUE_PHOTON_MEMBER std::uint32_t use() const { return use_; }
  /// The number of the next call; skips `count` of them.
  ETENDUE_PHOTON_MEMBER std::uint32_t take(std::uint32_t count) {
    event_ += count;
    return event_ - count;
  }

 private:
  std::uint64_t seed_;
  std::uint64_t history_;
  std::uint32_t use_;
  std::uint32_t event_ = 0;
};

/// In the open interval (0, 1), the middle of one of 2^32 equal parts: flights end within 22 mean free paths.
ETENDUE_PHOTON_INLINE double uniform(std::uint32_t word) {
  constexpr double part = 1.0 / 4294967296.0;
  return (static_cast<double>(word) + 0.5) * part;
}

}  // namespace etendue
