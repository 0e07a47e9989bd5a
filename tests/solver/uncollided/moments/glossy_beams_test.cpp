// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/moments/glossy_beams.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/materials/surfaces/phong.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::glossy_beams_test {
namespace {

/// A cube of a few cells with a glossy floor, and a spot from above that shines straight down.
Problem room(const TetrahedralMesh& mesh, const Vec3& position, double half_angle) {
  PointLight spot;
  spot.position = position;
  spot.power = {1};
  spot.axis = -Vec3::UnitZ();
  spot.angle = {0, half_angle};
  spot.intensity = {1, 1};
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, 0));
    if (name == "zmin") walls.back().glossy = {std::make_shared<Phong>(0.5, 5)};
    walls.back().name = name;
  }
  return Problem(mesh, {}, {uniform_medium(1, 0.01, 0, 0)}, walls, AngularSpace::sphere,
                 {{"spot", spot, {}}});
}

/// Power that all beams at the corners of a face bring.
double brought(const GlossyBeams& beams, std::size_t place) {
  double sum = 0;
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t k = 0; k < beams.arriving(place, corner).size(); ++k)
      sum += beams.arriving(place, corner).fluence(k)[0];
  return sum;
}

// A corner without beams would send all reflected light into one ordinate.
TEST(GlossyBeams, OfASpotBetweenTheCornersPointDownAtEachCorner) {
  const TetrahedralMesh mesh = cube_mesh(1);
  const double half_angle = 0.1;
  const Problem problem = room(mesh, {0.6, 0.3, 0.5}, half_angle);
  const LightSetup lights(problem);
  const GlossyBeams beams(lights.paths(), lights.sources(), 1);
  std::size_t lit = 0;
  for (std::size_t place = 0; place < beams.faces().size(); ++place) {
    if (!(brought(beams, place) > 0)) continue;
    ++lit;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const LightBeams& arriving = beams.arriving(place, corner);
      ASSERT_GT(arriving.size(), 0U);
      for (std::size_t k = 0; k < arriving.size(); ++k)
        EXPECT_GT(-arriving.direction(k).z(), std::cos(half_angle) - 1e-12);
    }
  }
  EXPECT_GE(lit, 1U);
}

// The mean over parts of the faces is the power of the spot, as far as the parts are small.
TEST(GlossyBeams, BetweenTheCornersBringThePowerOfTheSpot) {
  const TetrahedralMesh mesh = cube_mesh(1);
  const Problem problem = room(mesh, {0.62, 0.31, 0.5}, 0.3);
  const LightSetup lights(problem);
  const GlossyBeams beams(lights.paths(), lights.sources(), 1);
  double power = 0;
  for (std::size_t place = 0; place < beams.faces().size(); ++place)
    power += brought(beams, place) / 3 * mesh.area(FaceIndex(beams.faces()[place]));
  EXPECT_NEAR(power, std::exp(-0.01 * 0.5), 0.1);
}

// At the rim of a cone a corner that nothing shines on has the beams of those that are lit.
TEST(GlossyBeams, AtTheRimOfASpotNoCornerOfALitFaceIsWithout) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  const Problem problem = room(mesh, {0.5, 0.5, 0.5}, 0.5);
  const LightSetup lights(problem);
  const GlossyBeams beams(lights.paths(), lights.sources(), 1);
  std::size_t lit = 0, dark = 0;
  for (std::size_t place = 0; place < beams.faces().size(); ++place) {
    if (!(brought(beams, place) > 0)) {
      ++dark;
      continue;
    }
    ++lit;
    for (std::size_t corner = 0; corner < 3; ++corner) EXPECT_GT(beams.arriving(place, corner).size(), 0U);
  }
  EXPECT_GT(lit, 10U);
  EXPECT_GT(dark, 10U);
}

}  // namespace
}  // namespace etendue::glossy_beams_test
