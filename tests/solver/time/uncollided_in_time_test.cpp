// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/uncollided_in_time.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/field_view.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/time/delayed_courses.h"
#include "tests/solver/time/lit_rooms.h"

namespace etendue::uncollided_in_time_test {
namespace {

using namespace lit_rooms;

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
