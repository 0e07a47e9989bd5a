// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/laplace_inversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace etendue::laplace_inversion_test {
namespace {

using Complex = std::complex<double>;

/// A function of time and its transform.
struct Pair {
  std::string name;
  std::function<double(double)> function;
  std::function<Complex(Complex)> transform;
  double largest;  ///< of the function in the times below
};

const std::vector<double> times = {0.11, 0.2, 0.3, 0.5, 0.7, 0.9, 1};

std::vector<Pair> pairs() {
  return {
      {"decay", [](double t) { return std::exp(-2 * t); }, [](Complex s) { return 1.0 / (s + 2.0); }, 0.8},
      {"oscillation", [](double t) { return std::sin(7 * t); },
       [](Complex s) { return 7.0 / (s * s + 49.0); }, 1},
      {"diffusion",
       [](double t) { return std::exp(-1 / (4 * t)) / (2 * std::sqrt(std::numbers::pi) * std::pow(t, 1.5)); },
       [](Complex s) { return std::exp(-std::sqrt(s)); }, 0.91},
      {"front", [](double t) { return t < 0.25 ? 0 : (1 - std::exp(-3 * (t - 0.25))) / 3; },
       [](Complex s) { return std::exp(-0.25 * s) / (s * (s + 3.0)); }, 0.3},
      {"jump", [](double t) { return t < 0.4 ? 0 : 1; }, [](Complex s) { return std::exp(-0.4 * s) / s; },
       1}};
}

std::vector<ValueInTime> inverted(const Pair& pair, double unit, double noise = 0) {
  const LaplaceInversion inversion(unit);
  std::vector<Complex> transform;
  double sign = 1;
  for (const Complex& rate : inversion.rates()) {
    transform.push_back(unit * pair.transform(unit * rate) * (1 + noise * sign));
    sign = -sign;
  }
  std::vector<double> scaled;
  for (const double time : times) scaled.push_back(unit * time);
  return inversion.at(scaled, transform, noise);
}

TEST(LaplaceInversion, FindsFunctionsOfKnownTransforms) {
  for (const Pair& pair : pairs())
    for (const double unit : {1.0, 5e-9}) {
      const std::vector<ValueInTime> values = inverted(pair, unit);
      ASSERT_EQ(values.size(), times.size());
      for (std::size_t i = 0; i < times.size(); ++i)
        EXPECT_NEAR(values[i].value, pair.function(times[i]), 3e-6 * pair.largest) << pair.name << times[i];
    }
}

/// Transforms are known to the tolerance of an iteration alone.
TEST(LaplaceInversion, BearsErrorsOfTheTransform) {
  for (const Pair& pair : pairs()) {
    const std::vector<ValueInTime> values = inverted(pair, 1, 1e-8);
    for (std::size_t i = 0; i < times.size(); ++i)
      EXPECT_NEAR(values[i].value, pair.function(times[i]), 1e-4 * pair.largest) << pair.name << times[i];
  }
}

TEST(LaplaceInversion, StatesAnErrorThatHolds) {
  for (const Pair& pair : pairs())
    for (const double noise : {0.0, 1e-8, 1e-6}) {
      const std::vector<ValueInTime> values = inverted(pair, 1, noise);
      for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_LE(std::abs(values[i].value - pair.function(times[i])), values[i].error)
            << pair.name << " at " << times[i] << ", " << noise;
        EXPECT_LE(values[i].error, 1e-3 * pair.largest) << pair.name << " at " << times[i] << ", " << noise;
      }
    }
}

/// The transform of a pulse is constant, and of some pulses in a row a sum of few terms: their fractions end.
TEST(LaplaceInversion, KnowsThatAPulseIsPast) {
  const LaplaceInversion inversion(1);
  const std::vector<Complex> pulse(LaplaceInversion::rate_count, 3.0);
  for (const ValueInTime& value : inversion.at(times, pulse)) EXPECT_NEAR(value.value, 0, 1e-10);
}

TEST(LaplaceInversion, HasNothingOfADarkPlace) {
  const LaplaceInversion inversion(2);
  const std::vector<Complex> dark(LaplaceInversion::rate_count, 0.0);
  for (const ValueInTime& value : inversion.at(times, dark)) {
    EXPECT_EQ(value.value, 0);
    EXPECT_EQ(value.error, 0);
  }
}

TEST(LaplaceInversion, ServesADecadeOfTimes) {
  EXPECT_EQ(latest_times(std::vector{0.2, 1.0, 0.5}), std::vector{1.0});
  EXPECT_EQ(latest_times(std::vector{1e-3, 0.05, 1.0, 0.1, 0.11}), (std::vector{1.0, 0.1, 1e-3}));
  EXPECT_TRUE(latest_times({}).empty());
}

TEST(LaplaceInversion, RefusesWhatItCannotServe) {
  EXPECT_THROW(LaplaceInversion(0), std::invalid_argument);
  EXPECT_THROW(LaplaceInversion(std::nan("")), std::invalid_argument);
  const std::vector<Complex> few(7, 1.0);
  EXPECT_THROW(LaplaceInversion(1).at(times, few), std::invalid_argument);
}

}  // namespace
}  // namespace etendue::laplace_inversion_test
