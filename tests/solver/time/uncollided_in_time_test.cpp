// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/uncollided_in_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/field_view.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/time/delayed_courses.h"
#include "solver/time/flight_moments.h"
#include "solver/time/solve_laplace.h"
#include "solver/time/time_steps.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::uncollided_in_time_test {
namespace {

constexpr double pi = std::numbers::pi;

DelayFactors constant(double value) {
  return {1, 1, [value](const PathTime&, std::span<double> factors) { factors[0] = value; }};
}

PointLight lamp_at(const Vec3& position, std::vector<double> power) {
  PointLight lamp;
  lamp.position = position;
  lamp.power = std::move(power);
  return lamp;
}

struct Room {
  double absorption = 0.4, scattering = 1.1;
  PhaseFunction phase = PhaseIsotropic{};
  double wall_radiance = 0;                 ///< of zmax
  double region_emission = 0;               ///< of the inner box
  std::vector<double> mirror = {0.6, 0.7};  ///< xmin
  std::vector<Light> lights = {};
  double more = 0;  ///< absorption, in all regions
};

/// Two bands, walls that are grey.
Problem room(const TetrahedralMesh& mesh, const Room& is) {
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    Medium medium = uniform_medium(2, is.absorption + is.more, is.scattering, 0, is.phase);
    medium.name = name;
    medium.scattering[1] = Coefficient(2 * is.scattering);
    if (name == "inner") {
      medium.emission.assign(2, Coefficient(is.region_emission));
      medium.uncollided = Uncollided::yes;
    }
    media.push_back(std::move(medium));
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    Wall wall = uniform_wall(2, 0, 0.3, 0);
    wall.name = name;
    if (name == "xmin") wall.specular = is.mirror;
    if (name == "zmax") {
      wall.radiance.assign(2, is.wall_radiance);
      wall.uncollided = Uncollided::yes;
    }
    walls.push_back(std::move(wall));
  }
  return Problem(mesh, {{"a", "b"}, {}}, std::move(media), std::move(walls), AngularSpace::sphere, is.lights);
}

std::vector<Light> two_lamps() {
  PointLight spot = lamp_at(Vec3(0.7, 0.6, 0.8), {2, 0});
  spot.axis = -Vec3::UnitZ();
  spot.angle = {0, 0.6};
  spot.intensity = {1, 0.2};
  return {{"lamp", lamp_at(Vec3(0.21, 0.34, 0.3), {5, 3}), {}}, {"spot", spot, {}}};
}

Slowness alike(const Problem& problem, double slowness) { return Slowness(problem.media().size(), slowness); }

UncollidedInTime in_time(const LightSetup& lights, const Slowness& slowness,
                         const std::vector<TimedPlace>& places, int threads) {
  return {
      lights, slowness,
      std::make_shared<const UncollidedField>(uncollided_field(lights.paths(), lights.sources(), threads)),
      places, threads};
}

double largest_of(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

void expect_near(std::span<const double> values, std::span<const double> expected, double tolerance) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    ASSERT_NEAR(values[i], expected[i], tolerance * largest_of(expected)) << i;
}

/// Sum of the differences over that of the values, each times the measure of its cell or face.
double relative(std::span<const double> values, std::span<const double> expected,
                std::span<const double> measures) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double measure = measures[i * measures.size() / values.size()];
    difference += std::abs(values[i] - expected[i]) * measure;
    size += std::abs(expected[i]) * measure;
  }
  return difference / size;
}

/// Times of beams are those of straight paths, through media of different slowness and by a mirror.
TEST(PathTimes, AreThoseOfThePaths) {
  const TetrahedralMesh mesh = two_region_mesh(2e-2);
  Room is;
  is.lights = {{"lamp", lamp_at(Vec3(0.1, 0.5, 0.5), {1, 1}), {}}};
  const Problem problem = room(mesh, is);
  const LightSetup lights(problem);
  Slowness slowness;
  for (const std::string& name : mesh.region_names()) slowness.push_back(name == "inner" ? 1.5 : 1);
  const PathTimes times(lights, slowness);
  const CellLocator locator(mesh);
  const Vec3 behind(0.9, 0.5, 0.5);
  std::vector<double> found;
  LightBeams room_of_beams = times.room();
  times.finest_beams_at({locator.find(behind).front().cell, behind}, 0, room_of_beams,
                        [&](const TimedBeam& beam) { found.push_back(beam.time); });
  std::ranges::sort(found);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0], 0.8 + 0.5 * 0.5, 1e-9);
  EXPECT_NEAR(found[1], found[0] + 0.2, 1e-9);
}

/// Fields and places of light of which all is left, whatever sends it.
TEST(UncollidedInTime, IsTheSteadyLightWithoutDelay) {
  const TetrahedralMesh mesh = two_region_mesh(0.1);
  Room is;
  is.phase = PhaseHenyeyGreenstein{0.6};
  is.lights = two_lamps();
  is.wall_radiance = 0.4;
  const Problem problem = room(mesh, is);
  const LightSetup lights(problem);
  const UncollidedField steady = uncollided_field(lights.paths(), lights.sources(), 2);
  const Vec3 point(0.45, 0.3, 0.8);
  const PointInCell at{CellLocator(mesh).find(point).front().cell, point};
  const UncollidedInTime uncollided =
      in_time(lights, alike(problem, 1.3), {{at, {}}, {at, Vec3::UnitX()}}, 2);
  UncollidedValues values = uncollided.at(constant(1));
  expect_near(values.field.fluence, steady.fluence, 1e-12);
  expect_near(values.field.irradiance, steady.irradiance, 1e-12);
  ASSERT_FALSE(steady.collisions.empty());
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    ASSERT_EQ(values.field.collisions.directions_at(cell).size(),
              steady.collisions.directions_at(cell).size());
    for (std::size_t k = 0; k < steady.collisions.directions_at(cell).size(); ++k)
      expect_near(values.field.collisions.values(cell, k), steady.collisions.values(cell, k), 1e-10);
  }
  const LightAtPoint light = lights.at(at, Vec3::UnitX());
  for (std::size_t b = 0; b < 2; ++b) {
    // Places have finer beams.
    EXPECT_NEAR(values.places[b], light.fluence[b], 2e-5 * light.fluence[b]);
    EXPECT_NEAR(values.places[2 + b], light.irradiance[b], 2e-5 * light.irradiance[b]);
  }
  uncollided.set(constant(0), values);
  EXPECT_EQ(largest_of(values.field.fluence), 0);
  EXPECT_EQ(largest_of(values.places), 0);
}

/// [cell][4][band][3] Of what scatters by direction the sum of the directions that it comes from, times the
/// power density. What is complex has its real parts alone.
std::vector<double> momentum_of(const CollisionField& field, const TetrahedralMesh& mesh, std::size_t parts) {
  std::vector<double> momentum;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    std::vector<double> sum(24, 0);
    for (std::size_t k = 0; k < field.directions_at(cell).size(); ++k) {
      const Vec3& from = field.directions().direction(static_cast<std::size_t>(field.directions_at(cell)[k]));
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += field.values(cell, k)[i / 3 * parts] * from[static_cast<Eigen::Index>(i % 3)];
    }
    momentum.insert(momentum.end(), sum.begin(), sum.end());
  }
  return momentum;
}

/// Light that decays with its time is that of a medium that absorbs more.
void expect_that_of_more_absorption(const Room& is, double points, double cells, double faces,
                                    double max_volume = 5e-3) {
  const TetrahedralMesh mesh = two_region_mesh(max_volume);
  constexpr double rate = 0.8, slow = 1.5;
  Room darker = is;
  darker.more = rate * slow;
  const Problem problem = room(mesh, is), expected = room(mesh, darker);
  const LightSetup lights(problem), expected_lights(expected);
  ASSERT_FALSE(lights.empty());
  const UncollidedField field = uncollided_field(expected_lights.paths(), expected_lights.sources(), 2);
  const Vec3 point(0.4, 0.3, 0.15);
  const PointInCell at{CellLocator(mesh).find(point).front().cell, point};
  const UncollidedInTime uncollided = in_time(lights, alike(problem, slow), {{at, {}}}, 2);
  const std::vector<std::complex<double>> rates = {rate};
  const UncollidedValues values = uncollided.at(delay_factors(rates));
  const auto real_of = [](const std::vector<double>& all) {
    std::vector<double> real;
    for (std::size_t i = 0; i < all.size(); i += 2) {
      EXPECT_EQ(all[i + 1], 0);
      real.push_back(all[i]);
    }
    return real;
  };
  std::vector<double> areas;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) areas.push_back(mesh.area(FaceIndex(f)));
  const std::vector<double> one = {1};
  EXPECT_LT(relative(real_of(values.places), expected_lights.at(at, {}).fluence, one), points);
  EXPECT_LT(relative(real_of(values.field.fluence), field.fluence, mesh.volumes()), cells);
  EXPECT_LT(relative(real_of(values.field.irradiance), field.irradiance, areas), faces);
  if (field.collisions.empty()) return;
  EXPECT_LT(relative(momentum_of(values.field.collisions, mesh, 2), momentum_of(field.collisions, mesh, 1),
                     mesh.volumes()),
            cells);
}

TEST(UncollidedInTime, DecaysAsByMoreAbsorptionFromLamps) {
  Room is;
  is.lights = two_lamps();
  expect_that_of_more_absorption(is, 1e-9, 3e-3, 3e-3);
  expect_that_of_more_absorption(is, 1e-9, 1e-3, 1e-3, 5e-4);
}

TEST(UncollidedInTime, DecaysAsByMoreAbsorptionByDirection) {
  Room is;
  is.phase = PhaseHenyeyGreenstein{0.6};
  is.lights = {two_lamps().front()};
  expect_that_of_more_absorption(is, 1e-9, 3e-3, 3e-3);
}

TEST(UncollidedInTime, DecaysAsByMoreAbsorptionFromAWall) {
  Room is;
  is.wall_radiance = 1;
  expect_that_of_more_absorption(is, 2e-3, 4e-3, 6e-3);
}

TEST(UncollidedInTime, DecaysAsByMoreAbsorptionFromAMedium) {
  Room is;
  is.region_emission = 1;
  expect_that_of_more_absorption(is, 2e-3, 3e-3, 3e-3, 0.1);
}

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

const Course switched_on{false, [](double) { return 1.0; }};
const Course pulse{true, {}};

Room lit_room(const PhaseFunction& phase) {
  Room is;
  is.phase = phase;
  is.lights = two_lamps();
  is.wall_radiance = 0.2;
  return is;
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

/// A beam much thinner than cells, which no point of a rule meets, straight down.
Light narrow_beam(const Problem& problem, std::vector<double> irradiance) {
  BeamLight beam;
  beam.direction = -Vec3::UnitZ();
  beam.irradiance = std::move(irradiance);
  for (std::size_t w = 0; w < problem.walls().size(); ++w)
    if (problem.walls()[w].name == "zmax") beam.walls.push_back(static_cast<int>(w));
  beam.profile.emplace();
  beam.profile->center = Vec3(0.63, 0.37, 1);
  beam.profile->across = 1e4 * Vec3::UnitX();
  beam.profile->upright = 1e4 * Vec3::UnitY();
  return {"beam", beam, {}};
}

Room with_beam(const TetrahedralMesh& mesh) {
  Room is;
  is.mirror = {0, 0};
  is.lights = {{"lamp", lamp_at(Vec3(0.2, 0.6, 0.7), {2, 0}), {}}};
  const Problem walls = room(mesh, is);
  is.lights.push_back(narrow_beam(walls, {0, 3e8}));
  return is;
}

TEST(UncollidedInTime, HasBeamsThatAreThinnerThanCells) {
  const TetrahedralMesh mesh = two_region_mesh(2e-2);
  const Problem problem = room(mesh, with_beam(mesh));
  const LightSetup lights(problem);
  const UncollidedField steady = uncollided_field(lights.paths(), lights.sources(), 2);
  const UncollidedInTime uncollided = in_time(lights, alike(problem, 1), {}, 2);
  expect_near(uncollided.at(constant(1)).field.fluence, steady.fluence, 1e-12);
  // Attenuated by time in the middle of each cell: by less than a cell's size off.
  const std::vector<std::complex<double>> rates = {0.2};
  const UncollidedValues later = uncollided.at(delay_factors(rates));
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const double all = ConstCellField(steady.fluence, 2).mean(CellIndex(c), 1);
    if (all < 1e-9) continue;
    const double left = ConstCellField(later.field.fluence, 4).mean(CellIndex(c), 2) / all;
    EXPECT_NEAR(left, std::exp(-0.2 * (1 - mesh.centroid(CellIndex(c)).z())), 1e-9);
  }
}

/// What a light that is off leaves is the light of the others.
TEST(TimeSteps, HaveCoursesOfLightsAlongRays) {
  const TetrahedralMesh mesh = two_region_mesh(2e-2);
  Room both = with_beam(mesh), alone = both;
  alone.lights.resize(1);
  const Problem all = room(mesh, both), lamp = room(mesh, alone);
  const LightSetup lights(all), lamp_lights(lamp);
  EmissionCourses courses = one_course(all, pulse);
  courses.courses.push_back({false, [](double) { return 0.0; }});
  courses.lights[1] = 1;
  const UncollidedInTime uncollided = in_time(lights, alike(all, 1), {}, 2),
                         of_lamp = in_time(lamp_lights, alike(lamp, 1), {}, 2);
  const EmissionCourses lamp_course = one_course(lamp, pulse);
  const DelayedCourses delayed(uncollided, courses, 2), lamp_delayed(of_lamp, lamp_course, 2);
  for (const double t : {0.3, 0.7}) {
    const UncollidedValues values = uncollided.at(delayed.mean(t, t + 0.2)),
                           expected = of_lamp.at(lamp_delayed.mean(t, t + 0.2));
    expect_near(values.field.fluence, expected.field.fluence, 1e-10);
    expect_near(values.field.irradiance, expected.field.irradiance, 1e-10);
  }
}

/// A pulse in a medium that absorbs alone: e^(-sigma c t) of its energy is left as long as none has left.
TEST(UncollidedInTime, KeepsTheEnergyOfAPulseOnCoarseCells) {
  const TetrahedralMesh mesh = two_region_mesh(2e-2);
  Room is;
  is.mirror = {0, 0};
  is.lights = {{"lamp", lamp_at(Vec3(0.5, 0.52, 0.51), {1, 1}), {}}};
  const Problem problem = room(mesh, is);
  const LightSetup lights(problem);
  const UncollidedInTime uncollided = in_time(lights, alike(problem, 1), {}, 2);
  const EmissionCourses course = one_course(problem, pulse);
  const DelayedCourses delayed(uncollided, course, 1);
  for (const double t : {0.1, 0.2, 0.3, 0.4}) {
    const UncollidedValues values = uncollided.at(delayed.mean(t - 0.05, t + 0.05));
    double energy = 0;
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
      energy += ConstCellField(values.field.fluence, 2).mean(CellIndex(c), 0) * mesh.volume(CellIndex(c));
    const double sigma = is.absorption + is.scattering;
    EXPECT_NEAR(energy, std::exp(-sigma * t), 0.05) << t;
  }
}

/// Means of a course with a jump within a step, and of one that oscillates.
TEST(DelayedCourses, HaveMeansOverSteps) {
  const Course gate{false, [](double t) { return t < 0.02 ? 1.0 : 0.0; }};
  const CourseIntegral of_gate(gate, 1);
  EXPECT_NEAR(of_gate.mean(0.0, 0, 0.1), 0.2, 1e-3);
  EXPECT_NEAR(of_gate.mean(0.35, 0.3, 0.4), 0.2, 1e-3);
  EXPECT_EQ(of_gate.mean(0.5, 0.3, 0.4), 0);
  const Course wave{false, [](double t) { return 1 + std::sin(40 * t); }};
  const CourseIntegral of_wave(wave, 2);
  EXPECT_NEAR(of_wave.mean(0.5, 1, 2), 1 + (std::cos(20.0) - std::cos(60.0)) / 40, 1e-7);
  // Delays from 0.49 to 0.51.
  EXPECT_NEAR(of_wave.mean({0, 0.5, 0.02}, 1, 2),
              1 + (std::sin(20.4) - std::sin(19.6) - std::sin(60.4) + std::sin(59.6)) / (0.02 * 1600), 1e-5);
  EXPECT_NEAR(of_wave.at({0, 0.5, 0}, 0.9), 1 + std::sin(16.0), 1e-12);
  EXPECT_EQ(of_wave.at({0, 0.95, 0}, 0.9), 0);
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

/// At a point the transform of each beam is known: amplitude and phase of two rates and bands in their
/// places.
TEST(UncollidedInTime, HasComplexFactorsInTheirPlaces) {
  const TetrahedralMesh mesh = two_region_mesh(4e-2);
  Room is;
  is.mirror = {0, 0};
  is.lights = {{"lamp", lamp_at(Vec3(0.2, 0.6, 0.7), {2, 3}), {}}};
  const Problem problem = room(mesh, is);
  const LightSetup lights(problem);
  const Vec3 point(0.8, 0.3, 0.2);
  const PointInCell at{CellLocator(mesh).find(point).front().cell, point};
  const UncollidedInTime uncollided = in_time(lights, alike(problem, 1.3), {{at, {}}}, 2);
  const std::vector<std::complex<double>> rates = {{0, 0.7}, {0.2, 3}};
  const UncollidedValues values = uncollided.at(delay_factors(rates));
  const double time = 1.3 * (point - Vec3(0.2, 0.6, 0.7)).norm();
  const LightAtPoint light = lights.at(at, {});
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t b = 0; b < 2; ++b) {
      const std::complex<double> expected = light.fluence[b] * std::exp(-rates[r] * time);
      EXPECT_NEAR(values.places[(r * 2 + b) * 2], expected.real(), 1e-9);
      EXPECT_NEAR(values.places[(r * 2 + b) * 2 + 1], expected.imag(), 1e-9);
      // The field of a cell is near to it.
      const std::size_t node = at.cell.at() * 4 * 8 + (r * 2 + b) * 2;
      EXPECT_NEAR(values.field.fluence[node], expected.real(), std::abs(expected)) << r << b;
    }
}

}  // namespace
}  // namespace etendue::uncollided_in_time_test
