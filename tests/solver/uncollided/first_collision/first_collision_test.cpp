// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/first_collision.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "base/quadrature/simplex_rules.h"
#include "solver/uncollided/first_collision/solve_split.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::first_collision_test {
namespace {

const Vec3 place_of_lamp(0.4, 0.55, 0.6);

Light lamp() {
  PointLight point;
  point.position = place_of_lamp;
  point.power = {1};
  return {"lamp", point, {}};
}

/// A cone that is narrower than the cells, from the same place into a corner.
Light spot() {
  PointLight point;
  point.position = place_of_lamp;
  point.power = {1};
  point.axis = Vec3(-1, -1, -0.5).normalized();
  point.angle = {0, 0.15, 0.2};
  point.intensity = {1, 1, 0};
  return {"spot", point, {}};
}

Light sun(const TetrahedralMesh& mesh) {
  int top = 0;
  for (std::size_t i = 0; i < mesh.wall_names().size(); ++i)
    if (mesh.wall_names()[i] == "zmax") top = static_cast<int>(i);
  return {"sun", BeamLight{Vec3(0.3, -0.2, -1).normalized(), {1}, {top}}, {}};
}

Problem lit(const TetrahedralMesh& mesh, const Medium& medium, const Light& light) {
  std::vector<Medium> media(mesh.region_names().size(), medium);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].name = mesh.wall_names()[i];
  return Problem(mesh, {}, media, walls, AngularSpace::sphere, {light});
}

/// [ordinate][cell][4] the source of a field.
std::vector<std::vector<double>> sources(const FirstCollision& input, const DirectionSet& directions,
                                         const TetrahedralMesh& mesh) {
  std::vector<std::vector<double>> all;
  for (std::int32_t m = 0; m < directions.count(); ++m) {
    all.emplace_back(static_cast<std::size_t>(mesh.cell_count()) * 4, 0);
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
      input.add_projected_source(OrdinateIndex(m), CellIndex(c),
                                 std::span(all.back()).subspan(static_cast<std::size_t>(c) * 4, 4));
  }
  return all;
}

// 128 directions see a peak of g = 0.9 from the side, and its mean cosine as 0.865 to 0.93. Cells that hold
// the lamp, or are wider than its cone, are lit from many directions or in part.
TEST(FirstCollision, KeepsPowerAndNetFluxOfWhatScatters) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  ASSERT_GT(mesh.cell_count(), 100);
  const DirectionSet directions = directions_product(8);
  for (const Light& light : {lamp(), spot(), sun(mesh)})
    for (const double g : {0.5, 0.9, -0.4}) {
      const Problem problem = lit(mesh, uniform_medium(1, 0.3, 2, 0, PhaseHenyeyGreenstein{g}), light);
      const LightSetup lights(problem);
      const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
      const auto source = sources(FirstCollision(lights, field, directions, 1), directions, mesh);
      double largest = 0;
      for (const double value : field.fluence) largest = std::max(largest, std::abs(value));
      ASSERT_GT(largest, 0);
      for (std::size_t at = 0; at < field.fluence.size(); ++at) {
        double power = 0;
        Vec3 flux = Vec3::Zero(), expected;
        for (std::size_t m = 0; m < source.size(); ++m) {
          power += directions.weights()[m] * source[m][at];
          flux += directions.weights()[m] * source[m][at] * directions.directions()[m];
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
          expected[static_cast<Eigen::Index>(axis)] = 2 * g * field.net_flux[at * 3 + axis];
        EXPECT_NEAR(power, 2 * field.fluence[at], 1e-11 * largest) << light.name << " " << g;
        EXPECT_LT((flux - expected).norm(), 1e-8 * largest) << light.name << " " << g;
      }
    }
}

/// The mean over a cell of what a lamp sends there, T/(4 pi r^2), and of that scattered into a direction with
/// the phase function itself, by points that are much finer than the distance to the lamp.
struct Scattered {
  double fluence = 0;
  std::vector<double> into;
};
Scattered scattered_in(const SubTetrahedron& part, const std::array<Vec3, 4>& corners, int divisions,
                       double extinction, const PhaseFunction& phase, const DirectionSet& directions) {
  Scattered sum{0, std::vector<double>(static_cast<std::size_t>(directions.count()), 0)};
  if (divisions > 0) {
    for (const SubTetrahedron& child : equal_parts(part)) {
      const Scattered of = scattered_in(child, corners, divisions - 1, extinction, phase, directions);
      sum.fluence += of.fluence / 8;
      for (std::size_t m = 0; m < sum.into.size(); ++m) sum.into[m] += of.into[m] / 8;
    }
    return sum;
  }
  for (const CellPointWeight& point : four_point_rule()) {
    const auto shares = in_whole(point.barycentric, part);
    Vec3 ray = -place_of_lamp;
    for (std::size_t i = 0; i < 4; ++i) ray += shares[i] * corners[i];
    const double r = ray.norm();
    const double fluence = point.weight * std::exp(-extinction * r) / (4 * std::numbers::pi * r * r);
    sum.fluence += fluence;
    for (std::size_t m = 0; m < sum.into.size(); ++m)
      sum.into[m] += fluence * phase_value(phase, directions.directions()[m].dot(ray) / r);
  }
  return sum;
}

// 1,536 directions sum this phase function up to 1e-4, so that nothing is left of the scaling to the set.
// The remaining error is the interpolation between directions of light: points of the grid of 32 divisions
// are up to d = sqrt(6)/32 apart, and linear interpolation over d misses d^2/8 p'' of the peak, p''/p = 3
// g/(1 - g)^2.
TEST(FirstCollision, IsTheMeanOfTheExactSource) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const PhaseFunction phase = PhaseHenyeyGreenstein{0.6};
  const Problem problem = lit(mesh, uniform_medium(1, 0.3, 2, 0, phase), lamp());
  const LightSetup lights(problem);
  const DirectionSet directions = directions_ldfe_sq(4);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  const auto source = sources(FirstCollision(lights, field, directions, 1), directions, mesh);
  const double spacing = std::sqrt(6.0) / 32;
  const double interpolation = spacing * spacing / 8 * 3 * 0.6 / (0.4 * 0.4);
  int compared = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); c += 7) {
    const CellIndex cell(c);
    std::array<Vec3, 4> corners;
    double size = 0;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
    for (const Vec3& corner : corners) size = std::max(size, (corner - mesh.centroid(cell)).norm());
    if ((mesh.centroid(cell) - place_of_lamp).norm() < 1.2 * size) continue;
    ++compared;
    const Scattered exact = scattered_in(whole_cell(), corners, 3, 2.3, phase, directions);
    const double largest = 2 * exact.fluence * phase_value(phase, 1);
    for (std::size_t m = 0; m < source.size(); ++m) {
      double mean = 0;
      for (std::size_t i = 0; i < 4; ++i) mean += source[m][cell.at() * 4 + i] / 4;
      EXPECT_NEAR(mean, 2 * exact.into[m], interpolation * largest);
    }
  }
  EXPECT_GT(compared, 10);
}

// A wall of the same radiance everywhere lights its own points from half of all directions: their mean is
// half the normal, and what scatters keeps g of it.
TEST(FirstCollision, SendsTheLightOfAWallForwardBesideIt) {
  const TetrahedralMesh mesh = cube_mesh(0.005);
  const std::vector<Medium> media(1, uniform_medium(1, 0, 1, 0, PhaseHenyeyGreenstein{0.8}));
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  const auto lit_wall = static_cast<std::size_t>(mesh.wall(FaceIndex(0)));
  walls[lit_wall] = uniform_wall(1, 1, 0, 0);
  walls[lit_wall].uncollided = Uncollided::yes;
  const Problem problem(mesh, {}, media, walls);
  const LightSetup lights(problem);
  const DirectionSet directions = directions_ldfe_sq(2);
  const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
  const auto source = sources(FirstCollision(lights, field, directions, 1), directions, mesh);
  const Vec3 inwards = -mesh.area_normal(FaceIndex(0)).normalized();
  const double offset = inwards.dot(mesh.centroid(FaceIndex(0)));
  int seen = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const double distance = inwards.dot(mesh.centroid(cell)) - offset;
    if (distance > 0.1) continue;
    ++seen;
    double power = 0, forward = 0, fluence = 0, flux = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t at = cell.at() * 4 + i;
      fluence += field.fluence[at];
      for (std::size_t axis = 0; axis < 3; ++axis)
        flux += inwards[static_cast<Eigen::Index>(axis)] * field.net_flux[at * 3 + axis];
      for (std::size_t m = 0; m < source.size(); ++m) {
        power += directions.weights()[m] * source[m][at];
        forward += directions.weights()[m] * source[m][at] * directions.directions()[m].dot(inwards);
      }
    }
    EXPECT_NEAR(power / fluence, 1, 1e-12);
    EXPECT_NEAR(forward / power, 0.8 * flux / fluence, 0.01);
    EXPECT_GT(forward / power, 0.8 * 0.48);
  }
  EXPECT_GT(seen, 20);
}

}  // namespace
}  // namespace etendue::first_collision_test
