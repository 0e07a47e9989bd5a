// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/time_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "solver/solution/balance.h"
#include "solver/time/laplace_inversion.h"
#include "solver/time/solve_laplace.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::time_steps_test {
namespace {

constexpr double pi = std::numbers::pi;

Slowness alike(const Problem& problem, double slowness) { return Slowness(problem.media().size(), slowness); }

const Course pulse{true, {}};
const Course switched_on{false, [](double) { return 1.0; }};

/// Mean of the fluence of each band over the volume.
std::vector<double> mean_fluence(const Problem& problem, const Solution& solution) {
  std::vector<double> means(static_cast<std::size_t>(problem.band_count()), 0);
  double volume = 0;
  for (const std::vector<RegionPower>& region : region_powers(problem, solution)) {
    for (std::size_t b = 0; b < means.size(); ++b) means[b] += region[b].fluence_mean * region[b].volume;
    volume += region.front().volume;
  }
  for (double& mean : means) mean /= volume;
  return means;
}

StepOptions even_steps(StepMethod method, double until, double step) {
  StepOptions steps;
  steps.method = method;
  steps.until = until;
  steps.step = step;
  steps.read = mean_fluence;
  return steps;
}

/// A step that was taken, without what goes away.
struct Kept {
  double end;
  double error;
  std::vector<double> values, errors, energy, fluence;
  double imbalance;
};

std::vector<Kept> march(const Problem& problem, const DirectionSet& directions, double slowness,
                        const Course& course, const StepOptions& steps, const SolveOptions& options) {
  std::vector<Kept> kept;
  march_in_time(problem, directions, alike(problem, slowness), one_course(problem, course), steps, options,
                [&](const TimeStep& step) {
                  EXPECT_TRUE(step.converged);
                  kept.push_back({step.end, step.error, step.values, step.errors, step.energy,
                                  step.solution.fluence, step.imbalance});
                  return true;
                });
  return kept;
}

/// Order of a method by its errors at steps that halve.
double order_of(const std::vector<double>& errors) {
  return std::log2(errors[errors.size() - 2] / errors.back());
}

constexpr double absorption = 0.5, emission = 0.25, slow = 1.5;

/// Between mirrors n/c u' + sigma_a u = q sin(3 t).
double light_of_a_sine(double t) {
  const double w = 3, s2 = absorption * absorption + slow * slow * w * w;
  return 4 * pi * emission / s2 *
         (absorption * std::sin(w * t) - slow * w * std::cos(w * t) +
          slow * w * std::exp(-absorption * t / slow));
}

Problem mirrored(const TetrahedralMesh& mesh, int bands) {
  return uniform_problem(mesh, uniform_medium(bands, absorption, 1.5, emission),
                         uniform_wall(bands, 0, 0, 1));
}

TEST(TimeSteps, AreOfSecondOrderBetweenMirrors) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  const Course sine{false, [](double t) { return std::sin(3 * t); }};
  for (const StepMethod method : {StepMethod::sdirk2, StepMethod::bdf2})
    for (const SpaceOrder order : {SpaceOrder::linear, SpaceOrder::constant}) {
      SolveOptions options = tight_options();
      options.order = order;
      std::vector<double> errors;
      for (const double step : {0.1, 0.05}) {
        const std::vector<Kept> kept =
            march(mirrored(mesh, 3), directions_product(2), slow, sine, even_steps(method, 1, step), options);
        ASSERT_EQ(kept.size(), static_cast<std::size_t>(std::lround(1 / step)));
        ASSERT_EQ(kept.back().values.size(), 3U);
        EXPECT_EQ(kept.back().end, 1);
        for (const double value : kept.back().values) EXPECT_DOUBLE_EQ(value, kept.back().values.front());
        errors.push_back(std::abs(kept.back().values.front() - light_of_a_sine(1)));
        // In first order the change of a step is what its error is told to be.
        EXPECT_GT(kept.back().errors.front(), 0);
      }
      EXPECT_LT(errors.back(), 1e-2 * light_of_a_sine(1));
      EXPECT_NEAR(order_of(errors), 2, 0.1) << static_cast<int>(method);
    }
}

TEST(TimeSteps, LetAPulseDecay) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  const std::vector<Kept> kept = march(mirrored(mesh, 1), directions_product(2), slow, pulse,
                                       even_steps(StepMethod::sdirk2, 2, 0.02), tight_options());
  ASSERT_EQ(kept.size(), 100U);
  for (const Kept& step : kept) {
    const double expected = 4 * pi * emission / slow * std::exp(-absorption * step.end / slow);
    EXPECT_NEAR(step.values.front(), expected, 2e-5 * expected);
    EXPECT_NEAR(step.energy.front(), slow * expected, 2e-5 * slow * expected);
  }
}

/// A scene with all that reflects and scatters, in a region of its own course too.
Problem lively(const TetrahedralMesh& mesh, const PhaseFunction& phase) {
  Medium medium = uniform_medium(2, 0.3, 2, 0.7, phase);
  medium.scattering[1] = Coefficient(8.0);
  std::vector<Medium> media(mesh.region_names().size(), medium);
  media.back().emission.assign(2, Coefficient(0.0));
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(2, 0.9, 0.3, 0.2));
  walls.back().radiance[1] = 0;
  for (std::size_t r = 0; r < media.size(); ++r) media[r].name = mesh.region_names()[r];
  for (std::size_t w = 0; w < walls.size(); ++w) walls[w].name = mesh.wall_names()[w];
  return Problem(mesh, {{"a", "b"}, {}}, std::move(media), std::move(walls));
}

TEST(TimeSteps, KeepTheEnergy) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  const Problem problem = lively(mesh, PhaseHenyeyGreenstein{0.2});
  for (const Lumping lumping : {Lumping::none, Lumping::automatic}) {
    SolveOptions options = tight_options(lumping);
    options.tolerance = 1e-13;
    for (const StepMethod method : {StepMethod::sdirk2, StepMethod::bdf2}) {
      const std::vector<Kept> kept =
          march(problem, directions_product(4), 1, switched_on, even_steps(method, 1, 0.2), options);
      ASSERT_EQ(kept.size(), 5U);
      const double energy = kept.back().energy[0] + kept.back().energy[1];
      for (const Kept& step : kept) EXPECT_LT(step.imbalance, 1e-10 * energy);
    }
  }
}

/// The steady solution is a fixed point of steps of any length, lumped cells included.
TEST(TimeSteps, EndInTheSteadySolution) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  const Problem problem = lively(mesh, PhaseIsotropic{});
  SolveOptions options = tight_options(Lumping::automatic);
  options.tolerance = 1e-11;
  const Solution steady = solve(problem, directions_product(4), options);
  for (const StepMethod method : {StepMethod::sdirk2, StepMethod::bdf2}) {
    const std::vector<Kept> kept =
        march(problem, directions_product(4), 1, switched_on, even_steps(method, 1e7, 1e6), options);
    EXPECT_LT(relative_difference(kept.back().fluence, steady.fluence), 1e-8) << static_cast<int>(method);
  }
}

TEST(TimeSteps, AdaptToTheirTolerance) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  const Course sine{false, [](double t) { return std::sin(3 * t); }};
  StepOptions steps = even_steps(StepMethod::sdirk2, 1, 1);
  steps.scale = light_of_a_sine(1);
  double last = 1;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    steps.tolerance = tolerance;
    steps.stops = {0.3, 0.35};
    const std::vector<Kept> kept =
        march(mirrored(mesh, 1), directions_product(2), slow, sine, steps, tight_options());
    bool stopped = false;
    for (const Kept& step : kept) {
      EXPECT_LE(step.error, tolerance);
      stopped = stopped || step.end == 0.35;
    }
    EXPECT_TRUE(stopped);
    EXPECT_EQ(kept.back().end, 1);
    const double error = std::abs(kept.back().values.front() / light_of_a_sine(1) - 1);
    EXPECT_LT(error, tolerance);
    EXPECT_LT(error, last);
    last = error;
  }
}

/// Hardly any light comes before the pulse, and steps that miss it are taken back.
TEST(TimeSteps, FindAPulseThatIsShorterThanTheFirstSteps) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  const Course late{false, [](double t) { return std::exp(-std::pow((t - 2.53) / 0.05, 2)); }};
  StepOptions steps = even_steps(StepMethod::sdirk2, 4, 0.5);
  steps.tolerance = 1e-3;
  steps.scale = 1;
  const std::vector<Kept> kept =
      march(mirrored(mesh, 1), directions_product(2), slow, late, steps, tight_options());
  const double energy = 4 * pi * emission * 0.05 * std::sqrt(pi);
  const double expected = energy / slow * std::exp(-absorption * (4 - 2.53) / slow);
  EXPECT_NEAR(kept.back().values.front(), expected, 5e-3 * expected);
}

/// By transforms, without steps: an independent way to the same light.
std::vector<std::vector<double>> by_inversion(const Problem& problem, const DirectionSet& directions,
                                              double slowness, Course course,
                                              const std::vector<double>& times, SolveOptions options) {
  options.tolerance = 1e-10;
  const LaplaceInversion inversion(times.back());
  const auto bands = static_cast<std::size_t>(problem.band_count());
  std::vector<std::vector<std::complex<double>>> transforms(bands);
  solve_laplace(
      problem, {directions}, inversion.rates(), alike(problem, slowness), options,
      [&](const SolvedRates& solved) {
        const std::vector<double> means = mean_fluence(solved.problem, solved.solution);
        for (std::size_t i = 0; i < solved.count; ++i)
          for (std::size_t b = 0; b < bands; ++b) {
            const std::size_t real = 2 * (i * bands + b);
            const std::complex<double> value(means[real], means[real + 1]);
            transforms[b].push_back(course.is_pulse ? value : value / inversion.rates()[solved.first + i]);
          }
        return true;
      });
  std::vector<std::vector<double>> histories(times.size());
  for (std::size_t b = 0; b < bands; ++b) {
    const std::vector<ValueInTime> values = inversion.at(times, transforms[b]);
    for (std::size_t i = 0; i < times.size(); ++i) histories[i].push_back(values[i].value);
  }
  return histories;
}

void expect_both_ways_agree(const Problem& problem, const Course& course, double tolerance) {
  const std::vector<double> times = {0.25, 0.5, 1};
  SolveOptions options = tight_options();
  options.tolerance = 1e-7;
  const std::vector<std::vector<double>> expected =
      by_inversion(problem, directions_product(4), 1.3, course, times, options);
  StepOptions steps = even_steps(StepMethod::sdirk2, 1, 0.02);
  steps.stops = {0.25, 0.5};
  const std::vector<Kept> kept = march(problem, directions_product(4), 1.3, course, steps, options);
  std::size_t compared = 0;
  for (const Kept& step : kept)
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (step.end != times[i]) continue;
      for (std::size_t b = 0; b < step.values.size(); ++b, ++compared)
        EXPECT_NEAR(step.values[b], expected[i][b], tolerance * expected[i][b]) << "t = " << step.end;
    }
  EXPECT_EQ(compared, times.size() * static_cast<std::size_t>(problem.band_count()));
}

TEST(TimeSteps, AgreeWithTheInversionOfTransforms) {
  const TetrahedralMesh mesh = cube_with_ball(8e-2);
  expect_both_ways_agree(lively(mesh, PhaseHenyeyGreenstein{0.1}), switched_on, 5e-4);
}

TEST(TimeSteps, AgreeWithTheInversionAfterAPulse) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  Problem dark_walls = uniform_problem(mesh, uniform_medium(1, 0.3, 2, 0.7), uniform_wall(1, 0, 0.4, 0.1));
  expect_both_ways_agree(dark_walls, pulse, 1e-3);
}

TEST(TimeSteps, AgreeWithTheInversionWithLampsAndGlass) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0.4, 0.3, 0));
    walls.back().name = name;
    if (name == "zmax") {
      walls.back() = uniform_wall(1, 0.6, 0, 0);
      walls.back().name = name;
      walls.back().refractive_index = 1.4;
    }
  }
  Medium medium = uniform_medium(1, 0.2, 1, 0.1);
  medium.name = mesh.region_names().front();
  PointLight lamp;
  lamp.position = Vec3(0.4, 0.3, 0.6);
  lamp.power = {5};
  Light light{"lamp", lamp, {}, Uncollided::automatic};
  expect_both_ways_agree(Problem(mesh, {{"a"}, {}}, {medium}, walls, AngularSpace::sphere, {light}),
                         switched_on, 5e-4);
}

TEST(TimeSteps, HaveCoursesForEachSource) {
  const TetrahedralMesh mesh = cube_with_ball(4e-2);
  const Problem both = uniform_problem(mesh, uniform_medium(1, 0.3, 2, 0.7), uniform_wall(1, 0.5, 0, 0));
  const Problem walls = uniform_problem(mesh, uniform_medium(1, 0.3, 2, 0), uniform_wall(1, 0.5, 0, 0));
  const Problem media = uniform_problem(mesh, uniform_medium(1, 0.3, 2, 0.7), uniform_wall(1, 0, 0, 0));
  const Course late{false, [](double t) { return t > 0.45 ? 1.0 : 0.0; }};
  EmissionCourses courses = one_course(both, switched_on);
  courses.courses.push_back(late);
  courses.walls.assign(courses.walls.size(), 1);
  const StepOptions steps = even_steps(StepMethod::sdirk2, 1, 0.25);
  std::vector<double> sum;
  march_in_time(both, directions_product(4), alike(both, 1), courses, steps, tight_options(),
                [&](const TimeStep& step) {
                  sum.push_back(step.values.front());
                  return true;
                });
  const std::vector<Kept> of_media =
      march(media, directions_product(4), 1, switched_on, steps, tight_options());
  const std::vector<Kept> of_walls = march(walls, directions_product(4), 1, late, steps, tight_options());
  ASSERT_EQ(sum.size(), 4U);
  for (std::size_t i = 0; i < sum.size(); ++i)
    EXPECT_NEAR(sum[i], of_media[i].values.front() + of_walls[i].values.front(), 1e-8 * sum[i]);
}

TEST(TimeSteps, GiveTheSameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_with_ball(5e-4);
  const Problem problem = lively(mesh, PhaseIsotropic{});
  std::vector<double> first;
  for (const int threads : {1, 3}) {
    SolveOptions options;
    options.threads = threads;
    const std::vector<Kept> kept = march(problem, directions_product(4), 1, switched_on,
                                         even_steps(StepMethod::sdirk2, 0.2, 0.1), options);
    if (threads == 1) first = kept.back().fluence;
    EXPECT_EQ(kept.back().fluence, first);
  }
}

TEST(TimeSteps, RefuseWhatHasNoSense) {
  const TetrahedralMesh mesh = cube_mesh(8e-2);
  const Problem shining = uniform_problem(mesh, uniform_medium(1, 1, 0, 0), uniform_wall(1, 1, 0, 0));
  const auto refused = [&](const Course& course, const StepOptions& steps) {
    EXPECT_THROW(march(shining, directions_product(2), 1, course, steps, tight_options()),
                 std::invalid_argument);
  };
  refused(pulse, even_steps(StepMethod::sdirk2, 1, 0.1));  // through walls
  refused(switched_on, even_steps(StepMethod::sdirk2, 0, 0.1));
  refused(switched_on, even_steps(StepMethod::sdirk2, 1, 0));
  StepOptions adaptive = even_steps(StepMethod::bdf2, 1, 0.1);
  adaptive.tolerance = 1e-3;
  refused(switched_on, adaptive);
}

}  // namespace
}  // namespace etendue::time_steps_test
