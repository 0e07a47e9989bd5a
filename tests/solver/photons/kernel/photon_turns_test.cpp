// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/photons/kernel/photon_turns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/photons/kernel/random_events.h"
#include "solver/photons/sampling/angle_table.h"

namespace etendue::photon_turns_test {
namespace {

// The next terms of the series are (pi/4)^16/16! = 1e-15 of the cosine and (pi/4)^17/17! of the sine.
TEST(PhotonTurns, CircleIsRoundToTheEndOfItsSeries) {
  constexpr double next_term = 2e-15;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const std::uint32_t word = i * 4294967u;
    double c, s;
    unit_circle(word, c, s);
    EXPECT_NEAR(c * c + s * s, 1, 2 * next_term);
    const double angle =
        std::numbers::pi / 2 * ((word & 0x3FFFFFFF) + 0.5) / 1073741824.0 - std::numbers::pi / 4;
    // Quarters are chosen by the first two bits.
    const bool quarter = (word & 0x40000000) != 0, half = (word & 0x80000000) != 0;
    const double turned = angle + (quarter ? std::numbers::pi / 2 : 0) + (half ? std::numbers::pi : 0);
    EXPECT_NEAR(c, std::cos(turned), next_term);
    EXPECT_NEAR(s, std::sin(turned), next_term);
  }
}

// Four at a time as one by one.
TEST(RandomEvents, AreThoseOfTheStream) {
  RandomStream one(7, 0x123456789, RandomUse::flight), four = one;
  EventBlock block;
  for (int round = 0; round < 100; ++round) {
    block.draw(four);
    for (int i = 0; i < events_at_a_time; ++i) {
      std::uint32_t word[4];
      one.next(word);
      double c, s;
      unit_circle(word[2], c, s);
      EXPECT_NEAR(block.depth[i], -std::log(uniform(word[0])), 1e-15 * (1 + block.depth[i]));
      EXPECT_EQ(block.cosine_draw[i], uniform(word[1]));
      EXPECT_EQ(block.cosine[i], c);
      EXPECT_EQ(block.sine[i], s);
      EXPECT_EQ(block.side[i], word[3]);
    }
  }
}

// The mean cosine of deflection is g, whatever the medium's turns are found by; the last event turns nothing.
TEST(RandomEvents, TurnAsTheMediumSays) {
  for (const double g : {-0.7, 0.0, 5e-5, 0.85}) {
    Deflection how;
    how.kind = Deflection::Kind::henyey_greenstein;
    how.asymmetry = g;
    how.half_inverse = g != 0 ? 1 / (2 * g) : 0;
    RandomStream random(3, 1, RandomUse::flight);
    EventBlock block;
    TurnBlock turns;
    constexpr int rounds = 5000;
    double sum = 0;
    for (int round = 0; round < rounds; ++round) {
      block.draw(random);
      turns.find(block, how, false);
      for (int i = 0; i < events_at_a_time; ++i) {
        sum += turns.mu[i];
        EXPECT_NEAR(turns.mu[i] * turns.mu[i] + turns.u[i] * turns.u[i] + turns.v[i] * turns.v[i], 1, 1e-14);
      }
    }
    // The standard error is at most sqrt(1/3 / 40,000).
    EXPECT_NEAR(sum / (rounds * events_at_a_time), g, 0.01);
    EXPECT_EQ(turns.mu[events_at_a_time], 1);
    EXPECT_EQ(turns.u[events_at_a_time], 0);
  }
}

TEST(PhotonTurns, TurnKeepsTheLengthAndTheCosine) {
  for (const double z : {-1.0, -0.3, 0.0, 0.9, 1.0})
    for (const double mu : {-1.0, -0.2, 0.7, 1.0}) {
      const double w[3] = {std::sqrt(1 - z * z), 0, z};
      double turned[3] = {w[0], w[1], w[2]};
      turn(turned, mu, std::cos(1.1), std::sin(1.1));
      EXPECT_NEAR(turned[0] * w[0] + turned[1] * w[1] + turned[2] * w[2], mu, 1e-15);
      EXPECT_NEAR(turned[0] * turned[0] + turned[1] * turned[1] + turned[2] * turned[2], 1, 1e-15);
    }
}

// Intensity 1 to pi/3, then falling to 0 at pi/2: the mean cosine by its integrals.
TEST(AngleTable, DrawsTheAnglesOfItsIntensity) {
  using std::numbers::pi;
  const double angle[] = {0, pi / 3, pi / 2}, intensity[] = {1, 1, 0};
  const AngleTable table(angle, intensity);
  double sum = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) sum += std::cos(table.draw((i + 0.5) / count));
  double power = 0, moment = 0;
  for (int i = 0; i < 100000; ++i) {
    const double t = pi / 2 * (i + 0.5) / 100000;
    const double density = (t < pi / 3 ? 1 : (pi / 2 - t) / (pi / 6)) * std::sin(t);
    power += density;
    moment += density * std::cos(t);
  }
  EXPECT_NEAR(sum / count, moment / power, 1e-5);
}

}  // namespace
}  // namespace etendue::photon_turns_test
