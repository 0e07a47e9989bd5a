// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/conserve_moments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "solver/angular/sets/direction_set.h"
#include "solver/materials/phase/phase_function.h"

namespace etendue::conserve_moments_test {
namespace {

std::vector<Vec3> random_directions(int count) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i)
    directions.push_back(Vec3(normal(generator), normal(generator), normal(generator)).normalized());
  return directions;
}

std::vector<double> sampled(const DirectionSet& set, const PhaseFunction& phase, const Vec3& incident) {
  std::vector<double> p;
  for (const Vec3& w : set.directions())
    p.push_back(phase_value(phase, std::clamp(w.dot(incident), -1., 1.)));
  return p;
}

TEST(ConserveMoments, KeepsPowerAndMeanDirectionWithPositiveValues) {
  for (const DirectionSet& set : {directions_ldfe_sq(1), directions_ldfe_sq(2), directions_double_gauss(4)})
    for (const double g : {-0.5, 0.0, 0.6, 0.9})
      for (const Vec3& incident : random_directions(20)) {
        std::vector<double> p = sampled(set, PhaseHenyeyGreenstein{g}, incident);
        conserve_moments(set, g * incident, p);
        double power = 0;
        Vec3 flux = Vec3::Zero();
        for (std::size_t m = 0; m < p.size(); ++m) {
          EXPECT_GT(p[m], 0);
          power += set.weights()[m] * p[m];
          flux += set.weights()[m] * p[m] * set.directions()[m];
        }
        EXPECT_NEAR(power, 1, 1e-13);
        EXPECT_LT((flux - g * incident).norm(), 1e-9) << g;
      }
}

// Corrections that do not depend on p change what 384 directions see of g = 0.9 sideways by 30 %.
TEST(ConserveMoments, LeavesWhatScattersSidewaysAndBack) {
  const DirectionSet set = directions_ldfe_sq(2);
  for (const Vec3& incident : random_directions(50)) {
    const std::vector<double> before = sampled(set, PhaseHenyeyGreenstein{0.9}, incident);
    std::vector<double> after = before;
    conserve_moments(set, 0.9 * incident, after);
    int seen = 0;
    for (std::size_t m = 0; m < before.size(); ++m) {
      const double cosine = set.directions()[m].dot(incident);
      if (cosine > std::cos(0.7)) continue;
      ++seen;
      EXPECT_NEAR(after[m], before[m], (cosine < 0 ? 0.03 : 0.1) * before[m]) << cosine;
    }
    EXPECT_GT(seen, 300);
  }
}

TEST(ConserveMoments, KeepsThePowerWhereThePeakIsNarrowerThanTheSet) {
  const DirectionSet set = directions_double_gauss(2);
  const Vec3 incident = Vec3(1, 2, 3).normalized();
  std::vector<double> p = sampled(set, PhaseHenyeyGreenstein{0.995}, incident);
  conserve_moments(set, 0.995 * incident, p);
  double power = 0;
  for (std::size_t m = 0; m < p.size(); ++m) power += set.weights()[m] * p[m];
  EXPECT_NEAR(power, 1, 1e-12);
}

}  // namespace
}  // namespace etendue::conserve_moments_test
