// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Transforms, steps and moments whose light before its first collision follows rays.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/time/flight_moments.h"
#include "solver/time/solve_laplace.h"
#include "solver/time/time_steps.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/time/lit_rooms.h"

namespace etendue::light_along_rays_test {
namespace {

using namespace lit_rooms;

/// The whole light at a real rate is that of a medium that absorbs more, by other rays.
TEST(SolveLaplace, HasLightAlongRaysAsMoreAbsorption) {
  const TetrahedralMesh mesh = two_region_mesh(6e-3);
  constexpr double rate = 0.8, slow = 1.5;
  Room is;
  is.phase = PhaseHenyeyGreenstein{0.6};
  is.lights = two_lamps();
  is.wall_radiance = 0.2;
  Room darker = is;
  darker.more = rate * slow;
  const Problem problem = room(mesh, is), expected = room(mesh, darker);
  const LightSetup lights(problem), expected_lights(expected);
  const DirectionSet directions = directions_product(4);
  const SolveOptions options = tight_options();
  const Solution whole = solve_split(expected_lights, directions, options);
  const UncollidedInTime uncollided = in_time(lights, alike(problem, slow), {}, 2);
  const std::vector<std::complex<double>> rates = {rate, {0, 0.3}};
  solve_laplace(
      problem, {directions}, rates, alike(problem, slow), options,
      [&](const SolvedRates& solved) {
        EXPECT_EQ(solved.count, 2U);
        std::vector<double> fluence;
        for (std::size_t node = 0; node < whole.fluence.size() / 2; ++node)
          for (std::size_t b = 0; b < 2; ++b)
            fluence.push_back(solved.solution.fluence[8 * node + 2 * b] +
                              solved.uncollided->field.fluence[8 * node + 2 * b]);
        EXPECT_LT(relative(fluence, whole.fluence, mesh.volumes()), 3e-3);
        return true;
      },
      {}, &uncollided);
}

struct Marched {
  std::vector<double> fluence, along_rays;  ///< of the rest, and of that
  double imbalance = 0, energy = 0;
  double place = 0;  ///< of light along rays

  std::vector<double> whole() const {
    std::vector<double> sum = fluence;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += along_rays[i];
    return sum;
  }
};

std::vector<Marched> march(const Problem& problem, const UncollidedInTime& uncollided,
                           const DirectionSet& directions, double slow, const Course& course,
                           StepMethod method, double until, double step, int threads = 2) {
  StepOptions steps;
  steps.method = method;
  steps.until = until;
  steps.step = step;
  SolveOptions options = tight_options();
  options.threads = threads;
  options.tolerance = 1e-12;
  std::vector<Marched> marched;
  march_in_time(
      problem, directions, alike(problem, slow), one_course(problem, course), steps, options,
      [&](const TimeStep& taken) {
        Marched now{taken.solution.fluence, taken.uncollided->field.fluence, taken.imbalance,
                    taken.energy.front(), 0};
        if (!taken.uncollided->places.empty()) now.place = taken.uncollided->places.front();
        marched.push_back(std::move(now));
        return true;
      },
      {}, &uncollided);
  return marched;
}

/// Whatever the steps, they keep the energy and end in the light of a steady run.
TEST(TimeSteps, EndInTheSteadyLightAlongRays) {
  const TetrahedralMesh mesh = two_region_mesh(4e-2);
  const std::pair<PhaseFunction, StepMethod> ways[] = {{PhaseIsotropic{}, StepMethod::bdf2},
                                                       {PhaseHenyeyGreenstein{0.6}, StepMethod::sdirk2}};
  for (const auto& [phase, method] : ways) {
    const Problem problem = room(mesh, lit_room(phase));
    const LightSetup lights(problem);
    const DirectionSet directions = directions_product(2);
    const Solution steady = solve_split(lights, directions, tight_options());
    const UncollidedInTime uncollided = in_time(lights, alike(problem, 1.5), {}, 2);
    const std::vector<Marched> marched =
        march(problem, uncollided, directions, 1.5, switched_on, method, 120, 10);
    expect_near(marched.back().whole(), steady.fluence, 1e-8);
    for (const Marched& step : marched) EXPECT_LT(step.imbalance, 1e-9 * marched.back().energy);
  }
}

/// No light is there before its path is done, and all of a pulse arrives.
TEST(TimeSteps, HaveFrontsAlongRays) {
  const TetrahedralMesh mesh = two_region_mesh(4e-2);
  Room is;
  is.mirror = {0, 0};
  is.scattering = 0;
  is.lights = {{"lamp", lamp_at(Vec3(0.1, 0.5, 0.5), {1, 1}), {}}};
  const Problem problem = room(mesh, is);
  const LightSetup lights(problem);
  const Vec3 far(0.95, 0.5, 0.5);
  constexpr double slow = 1.2, arrives = 1.2 * 0.85;
  const UncollidedInTime uncollided =
      in_time(lights, alike(problem, slow), {{{CellLocator(mesh).find(far).front().cell, far}, {}}}, 2);
  const double steady = std::exp(-0.85 * is.absorption) / (4 * pi * 0.85 * 0.85);
  const double step = 0.05;
  const auto on =
      march(problem, uncollided, directions_product(2), slow, switched_on, StepMethod::sdirk2, 1.5, step);
  double all = 0, t = 0;
  for (const Marched& now : on) {
    t += step;
    EXPECT_NEAR(now.place, t > arrives ? steady : 0, 1e-9) << t;
  }
  for (const Marched& now :
       march(problem, uncollided, directions_product(2), slow, pulse, StepMethod::sdirk2, 1.5, step))
    all += step * now.place;
  EXPECT_NEAR(all, steady, 1e-9);
}

/// Steps, moments and transforms of the same light agree: after a pulse the integral over time is the steady
/// light, that of t times it the first moment.
TEST(FlightMoments, AreThoseOfAPulseAlongRays) {
  const TetrahedralMesh mesh = two_region_mesh(4e-2);
  const Problem problem = room(mesh, lit_room(PhaseIsotropic{}));
  const LightSetup lights(problem);
  const DirectionSet directions = directions_product(2);
  const UncollidedInTime uncollided = in_time(lights, alike(problem, 1), {}, 2);
  std::vector<std::vector<double>> moments;
  solve_flight_moments(
      problem, directions, alike(problem, 1), 1, tight_options(),
      [&](int, const Problem&, const Solution& moment, const UncollidedValues* along_rays) {
        std::vector<double> fluence = moment.fluence;
        for (std::size_t i = 0; i < fluence.size(); ++i) fluence[i] += along_rays->field.fluence[i];
        moments.push_back(std::move(fluence));
      },
      {}, &uncollided);
  ASSERT_EQ(moments.size(), 2U);
  const Solution steady = solve_split(lights, directions, tight_options());
  expect_near(moments[0], steady.fluence, 1e-8);
  std::vector<double> all(moments[0].size(), 0), delayed = all;
  constexpr double step = 0.1;
  double end = 0;
  for (const Marched& now : march(problem, uncollided, directions, 1, pulse, StepMethod::sdirk2, 12, step)) {
    end += step;
    for (std::size_t i = 0; i < all.size(); ++i) {
      // Along rays it is the mean over the step.
      all[i] += step * (now.fluence[i] + now.along_rays[i]);
      delayed[i] += step * (end * now.fluence[i] + (end - step / 2) * now.along_rays[i]);
    }
  }
  EXPECT_LT(relative(all, moments[0], mesh.volumes()), 2e-3);
  EXPECT_LT(relative(delayed, moments[1], mesh.volumes()), 2e-2);
}

TEST(TimeSteps, GiveTheSameBitsAlongRaysForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = two_region_mesh(4e-2);
  const Problem problem = room(mesh, lit_room(PhaseIsotropic{}));
  const LightSetup lights(problem);
  std::vector<double> first;
  for (const int threads : {1, 3}) {
    const UncollidedInTime uncollided = in_time(lights, alike(problem, 1), {}, threads);
    const auto marched = march(problem, uncollided, directions_product(2), 1, switched_on, StepMethod::sdirk2,
                               0.6, 0.3, threads);
    if (threads == 1) first = marched.back().fluence;
    EXPECT_EQ(marched.back().fluence, first);
  }
}

/// Backward differences keep all light of a pulse too.
TEST(TimeSteps, KeepAllOfAPulseByDifferences) {
  const TetrahedralMesh mesh = two_region_mesh(4e-2);
  const Problem problem = room(mesh, lit_room(PhaseIsotropic{}));
  const LightSetup lights(problem);
  const DirectionSet directions = directions_product(2);
  const UncollidedInTime uncollided = in_time(lights, alike(problem, 1), {}, 2);
  const Solution steady = solve_split(lights, directions, tight_options());
  std::vector<double> errors;
  for (const double step : {0.2, 0.1}) {
    std::vector<double> all(static_cast<std::size_t>(mesh.cell_count()) * 8, 0);
    for (const Marched& now : march(problem, uncollided, directions, 1, pulse, StepMethod::bdf2, 12, step))
      for (std::size_t i = 0; i < all.size(); ++i) all[i] += step * (now.fluence[i] + now.along_rays[i]);
    errors.push_back(relative(all, steady.fluence, mesh.volumes()));
  }
  // The first step is of the other kind, and the difference of second order.
  EXPECT_LT(errors[1], 0.01);
  EXPECT_LT(errors[1], 0.4 * errors[0]);
}

}  // namespace
}  // namespace etendue::light_along_rays_test
