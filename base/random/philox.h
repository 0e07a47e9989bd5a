// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "base/random/photon_inline.h"

namespace etendue {

/// Four random words from a counter and a key: Philox4x32-10 (Salmon, Moraes, Dror, Shaw 2011, section 3.3).
/// Different counters give independent words, so any number of a history can be had without those before it.
using PhiloxWords = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

ETENDUE_PHOTON_INLINE void philox4x32(std::uint32_t (&word)[4], std::uint32_t key0, std::uint32_t key1) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * word[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * word[2];
    const std::uint32_t next0 = static_cast<std::uint32_t>(b >> 32) ^ word[1] ^ key0;
    const std::uint32_t next2 = static_cast<std::uint32_t>(a >> 32) ^ word[3] ^ key1;
    word[1] = static_cast<std::uint32_t>(b);
    word[3] = static_cast<std::uint32_t>(a);
    word[0] = next0;
    word[2] = next2;
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
}

ETENDUE_PHOTON_INLINE PhiloxWords philox4x32(const PhiloxWords& counter, const PhiloxKey& key) {
  std::uint32_t word[4] = {counter[0], counter[1], counter[2], counter[3]};
  philox4x32(word, key[0], key[1]);
  return {word[0], word[1], word[2], word[3]};
}

}  // namespace etendue
