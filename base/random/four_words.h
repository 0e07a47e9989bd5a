// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/random/philox.h"

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

ETENDUE_PHOTON_INLINE Four load(const double* from) {
  Four value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
ETENDUE_PHOTON_INLINE void store(double* to, const Four& value) { std::memcpy(to, &value, sizeof value); }

ETENDUE_PHOTON_INLINE Four root_of(const Four& x) {
#ifdef __AVX2__
  __m256d value;
  std::memcpy(&value, &x, sizeof value);
  value = _mm256_sqrt_pd(value);
  Four root;
  std::memcpy(&root, &value, sizeof root);
  return root;
#else
  return Four{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

/// The place of the least of four numbers, and the number.
ETENDUE_PHOTON_INLINE int place_of_least(const Four& x, double& least) {
#ifdef __AVX2__
  // Without branches: which it is cannot be foreseen.
  __m256d value;
  std::memcpy(&value, &x, sizeof value);
  const __m256d pairs = _mm256_min_pd(value, _mm256_permute_pd(value, 5));
  const __m256d all = _mm256_min_pd(pairs, _mm256_permute2f128_pd(pairs, pairs, 1));
  least = _mm256_cvtsd_f64(all);
  return __builtin_ctz(static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(value, all, _CMP_LE_OQ))) | 8u);
#else
  const bool one = x[1] < x[0], three = x[3] < x[2];
  const double low = one ? x[1] : x[0], high = three ? x[3] : x[2];
  const bool upper = high < low;
  least = upper ? high : low;
  return upper ? 2 + three : 0 + one;
#endif
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
