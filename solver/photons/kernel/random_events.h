// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/random/four_words.h"
#include "base/random/random_stream.h"
#include "solver/photons/kernel/photon_scene.h"

namespace etendue {

/// -log(x) of 0 < x < 1: x = 2^e m with m from sqrt(1/2) to sqrt(2), log m = 2 atanh((m - 1)/(m + 1)) by its
/// series, which ends below 1e-15.
ETENDUE_PHOTON_INLINE Four minus_log(const Four& x) {
  FourWords bits;
  std::memcpy(&bits, &x, sizeof x);
  const FourWords mantissa = (bits & 0x000FFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL;
  Four m, e = to_numbers(bits >> 52) - 1023.0;
  std::memcpy(&m, &mantissa, sizeof m);
  const auto upper = m > 1.4142135623730951;
  e = upper ? e + 1.0 : e;
  m = upper ? m * 0.5 : m;
  const Four s = (m - 1.0) / (m + 1.0), z = s * s, q = z * z, o = q * q;
  const Four series = ((1. / 3 + z * (1. / 5)) + (1. / 7 + z * (1. / 9)) * q) +
                      ((1. / 11 + z * (1. / 13)) + (1. / 15 + z * (1. / 17)) * q) * o;
  return -(e * 0.69314718055994531 + 2.0 * s * (1.0 + z * series));
}

/// unit_circle of four words.
ETENDUE_PHOTON_INLINE void unit_circles(const FourWords& word, Four& cosine, Four& sine) {
  constexpr double part = 1.5707963267948966 / 1073741824.0;
  const Four t = (to_numbers(word & 0x3FFFFFFF) + 0.5) * part - 0.78539816339744831;
  const Four s = t * t, q = s * s, o = q * q;
  const Four c = ((1.0 + s * (-1. / 2)) + (1. / 24 + s * (-1. / 720)) * q) +
                 ((1. / 40320 + s * (-1. / 3628800)) + (1. / 479001600 + s * (-1. / 87178291200.)) * q) * o;
  const Four v =
      t * (((1.0 + s * (-1. / 6)) + (1. / 120 + s * (-1. / 5040)) * q) +
           ((1. / 362880 + s * (-1. / 39916800)) + (1. / 6227020800. + s * (-1. / 1307674368000.)) * q) * o);
  const auto swap = (word & 0x40000000) != 0;
  const auto turn = (word & 0x80000000) != 0;
  const Four x = swap ? -v : c, y = swap ? c : v;
  cosine = turn ? -x : x;
  sine = turn ? -y : y;
}

/// The next four calls of random.next() at a time.
ETENDUE_PHOTON_INLINE void next_four(RandomStream& random, FourWords (&word)[4]) {
  const std::uint64_t event = random.take(4);
  word[0] = repeat_word(random.history() & 0xFFFFFFFF);
  word[1] = repeat_word(random.history() >> 32);
  word[2] = FourWords{event, event + 1, event + 2, event + 3};
  word[3] = repeat_word(random.use());
  philox4x32(word, static_cast<std::uint32_t>(random.seed()),
             static_cast<std::uint32_t>(random.seed() >> 32));
}

/// Henyey and Greenstein's (1941) cosine, inverted in closed form; to first order in g where g is small.
ETENDUE_PHOTON_INLINE Four henyey_greenstein(const Deflection& how, const Four& d) {
  const double g = how.asymmetry;
  const Four even = 2.0 * d - 1.0;
  if (std::abs(g) < 1e-4) return even + 1.5 * g * (1.0 - even * even);
  const Four root = (1 - g * g) / ((1 - g) + (2 * g) * d);
  const Four mu = ((1 + g * g) - root * root) * how.half_inverse;
  const Four above = mu < -1.0 ? repeat_number(-1) : mu;
  return above > 1.0 ? repeat_number(1) : above;
}

constexpr int events_at_a_time = 8;

/// What some scatterings need of chance, drawn together: the processor computes it beside the path through
/// the next cells, which does not wait for it.
struct EventBlock {
  alignas(32) double depth[events_at_a_time];        ///< scattering optical depth to the next
  alignas(32) double cosine_draw[events_at_a_time];  ///< uniform number for the cosine of deflection
  alignas(32) double cosine[events_at_a_time];       ///< of the azimuth
  alignas(32) double sine[events_at_a_time];
  alignas(32) std::uint64_t side[events_at_a_time];  ///< odd: to the left, in the plane

  ETENDUE_PHOTON_MEMBER void draw(RandomStream& random) {
    for (int first = 0; first < events_at_a_time; first += 4) {
      FourWords word[4];
      next_four(random, word);
      constexpr double part = 1.0 / 4294967296.0;
      Four c, s;
      unit_circles(word[2], c, s);
      store(depth + first, minus_log((to_numbers(word[0]) + 0.5) * part));
      store(cosine_draw + first, (to_numbers(word[1]) + 0.5) * part);
      store(cosine + first, c);
      store(sine + first, s);
      std::memcpy(side + first, &word[3], sizeof word[3]);
    }
  }
};

/// Where the events of a block turn light to in one medium: mu along the direction before, u and v across it
/// (in the plane u to the left). Behind them stands the event that turns nothing.
struct TurnBlock {
  alignas(32) double mu[events_at_a_time + 1];
  alignas(32) double u[events_at_a_time + 1];
  alignas(32) double v[events_at_a_time + 1];

  ETENDUE_PHOTON_MEMBER TurnBlock() {
    mu[events_at_a_time] = 1;
    u[events_at_a_time] = v[events_at_a_time] = 0;
  }

  ETENDUE_PHOTON_MEMBER void find(const EventBlock& events, const Deflection& how, bool in_plane) {
    for (int first = 0; first < events_at_a_time; first += 4) {
      if (in_plane && how.kind == Deflection::Kind::isotropic) {
        store(mu + first, load(events.cosine + first));
        store(u + first, load(events.sine + first));
        continue;
      }
      const Four cosine = cosines_of(how, events.cosine_draw + first);
      const Four square = 1.0 - cosine * cosine;
      const Four sine = root_of(square > 0 ? square : Four{});
      store(mu + first, cosine);
      if (in_plane) {
        FourWords side;
        std::memcpy(&side, events.side + first, sizeof side);
        store(u + first, (side & 1) != 0 ? sine : -sine);
      } else {
        store(u + first, sine * load(events.cosine + first));
        store(v + first, sine * load(events.sine + first));
      }
    }
  }

 private:
  ETENDUE_PHOTON_MEMBER static Four cosines_of(const Deflection& how, const double* draw) {
    const Four d = load(draw);
    if (how.kind == Deflection::Kind::isotropic) return 2.0 * d - 1.0;
    if (how.kind == Deflection::Kind::henyey_greenstein) return henyey_greenstein(how, d);
    return Four{sampled_cosine(*how.sampler, draw[0]), sampled_cosine(*how.sampler, draw[1]),
                sampled_cosine(*how.sampler, draw[2]), sampled_cosine(*how.sampler, draw[3])};
  }
};

}  // namespace etendue
