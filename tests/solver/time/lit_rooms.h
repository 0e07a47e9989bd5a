// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/time/uncollided_in_time.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::lit_rooms {

inline constexpr double pi = std::numbers::pi;

inline DelayFactors constant(double value) {
  return {1, 1, [value](const PathTime&, std::span<double> factors) { factors[0] = value; }};
}

inline PointLight lamp_at(const Vec3& position, std::vector<double> power) {
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
inline Problem room(const TetrahedralMesh& mesh, const Room& is) {
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

inline std::vector<Light> two_lamps() {
  PointLight spot = lamp_at(Vec3(0.7, 0.6, 0.8), {2, 0});
  spot.axis = -Vec3::UnitZ();
  spot.angle = {0, 0.6};
  spot.intensity = {1, 0.2};
  return {{"lamp", lamp_at(Vec3(0.21, 0.34, 0.3), {5, 3}), {}}, {"spot", spot, {}}};
}

inline Slowness alike(const Problem& problem, double slowness) {
  return Slowness(problem.media().size(), slowness);
}

inline UncollidedInTime in_time(const LightSetup& lights, const Slowness& slowness,
                                const std::vector<TimedPlace>& places, int threads) {
  return {
      lights, slowness,
      std::make_shared<const UncollidedField>(uncollided_field(lights.paths(), lights.sources(), threads)),
      places, threads};
}

inline double largest_of(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

inline void expect_near(std::span<const double> values, std::span<const double> expected, double tolerance) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    ASSERT_NEAR(values[i], expected[i], tolerance * largest_of(expected)) << i;
}

/// Sum of the differences over that of the values, each times the measure of its cell or face.
inline double relative(std::span<const double> values, std::span<const double> expected,
                       std::span<const double> measures) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double measure = measures[i * measures.size() / values.size()];
    difference += std::abs(values[i] - expected[i]) * measure;
    size += std::abs(expected[i]) * measure;
  }
  return difference / size;
}

inline const Course switched_on{false, [](double) { return 1.0; }};
inline const Course pulse{true, {}};

inline Room lit_room(const PhaseFunction& phase) {
  Room is;
  is.phase = phase;
  is.lights = two_lamps();
  is.wall_radiance = 0.2;
  return is;
}

/// A beam much thinner than cells, which no point of a rule meets, straight down.
inline Light narrow_beam(const Problem& problem, std::vector<double> irradiance) {
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

inline Room with_beam(const TetrahedralMesh& mesh) {
  Room is;
  is.mirror = {0, 0};
  is.lights = {{"lamp", lamp_at(Vec3(0.2, 0.6, 0.7), {2, 0}), {}}};
  const Problem walls = room(mesh, is);
  is.lights.push_back(narrow_beam(walls, {0, 3e8}));
  return is;
}

}  // namespace etendue::lit_rooms
