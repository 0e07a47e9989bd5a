// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>

#include "solver/photons/philox.h"

#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace etendue {

/// Four numbers side by side.
using Four = double __attribute__((vector_size(32)));
using FourWords = unsigned long long __attribute__((vector_size(32)));

ETENDUE_PHOTON_INLINE FourWords low_times(const FourWords& a, const FourWords& b) {
#ifdef __AVX2__
  FourWords product;
  __m256i x, y;
  std::memcpy(&x, &a, sizeof x);
  std::memcpy(&y, &b, sizeof y);
  const __m256i z = _mm256_mul_epu32(x, y);
  std::memcpy(&product, &z, sizeof z);
  return product;
#else
  return (a & 0xFFFFFFFF) * (b & 0xFFFFFFFF);
#endif
}

ETENDUE_PHOTON_INLINE FourWords repeat_word(std::uint64_t word) { return word - FourWords{}; }
ETENDUE_PHOTON_INLINE Four repeat_number(double number) { return number - Four{}; }

/// Words below 2^52 as numbers: they become the last digits of 2^52.
ETENDUE_PHOTON_INLINE Four to_numbers(const FourWords& words) {
  const FourWords bits = words | 0x4330000000000000ULL;
  Four numbers;
  std::memcpy(&numbers, &bits, sizeof bits);
  return numbers - 4503599627370496.0;
}

/// philox4x32 of four counters at a time; only the last 32 bits of each word count.
ETENDUE_PHOTON_INLINE void philox4x32(FourWords (&word)[4], std::uint32_t key0, std::uint32_t key1) {
  const FourWords first = repeat_word(0xD2511F53), second = repeat_word(0xCD9E8D57);
  for (int round = 0; round < 10; ++round) {
    const FourWords a = low_times(first, word[0]), b = low_times(second, word[2]);
    word[0] = (b >> 32) ^ word[1] ^ key0;
    word[2] = (a >> 32) ^ word[3] ^ key1;
    word[1] = b;
    word[3] = a;
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
  for (FourWords& each : word) each &= 0xFFFFFFFF;
}

}  // namespace etendue
