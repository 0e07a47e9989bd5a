// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Disc and Gaussian beams that enter by a wall, against the law of Beer and Lambert and the closed forms of
// their power.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/lights/light_setup.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::round_beam_test {
namespace {

using std::numbers::pi;
using enum BeamProfile::Shape;

int wall_named(const TetrahedralMesh& mesh, const std::string& name) {
  return static_cast<int>(std::ranges::find(mesh.wall_names(), name) - mesh.wall_names().begin());
}

/// Straight down through the top of the unit cube, with an irradiance of 1 on its axis.
Problem with_beam(const TetrahedralMesh& mesh, BeamProfile::Shape shape, double radius, double x, double y,
                  double absorption = 2) {
  const BeamProfile profile{shape, {x, y, 3}, Vec3::UnitX() / radius, Vec3::UnitY() / radius};
  const BeamLight beam{-Vec3::UnitZ(), {1}, {wall_named(mesh, "zmax")}, 0, profile};
  return Problem(mesh, {}, {uniform_medium(1, absorption, 0, 0)},
                 std::vector<Wall>(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0)), AngularSpace::sphere,
                 {Light{"beam", beam, {}}});
}

// A Gaussian of which a side of the cube cuts a part off: the power is a product of error functions.
TEST(RoundBeam, SendsWhatEntersByItsWall) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const double w = 0.3;
  const auto part = [&](double middle) {
    return std::sqrt(pi / 8) * w *
           (std::erf(std::sqrt(2) * (1 - middle) / w) + std::erf(std::sqrt(2) * middle / w));
  };
  const Problem cut_off = with_beam(mesh, BeamProfile::Shape::gaussian, w, 0.2, 0.55);
  EXPECT_NEAR(LightSetup(cut_off).sources()[0]->power()[0] / (part(0.2) * part(0.55)), 1, 1e-6);
  const Problem disc_beam = with_beam(mesh, disc, 0.3, 0.5, 0.55);
  EXPECT_NEAR(LightSetup(disc_beam).sources()[0]->power()[0] / (pi * 0.09), 1, 1e-9);
}

// E exp(-2 r^2/w^2) exp(-sigma z); of a disc the same all over it and nothing beyond.
TEST(RoundBeam, FollowsBeerAndLambertAlongItsRays) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const CellLocator locator(mesh);
  for (const BeamProfile::Shape shape : {disc, gaussian}) {
    const Problem problem = with_beam(mesh, shape, 0.2, 0.4, 0.5);
    const LightSetup lights(problem);
    for (const Vec3& point : {Vec3(0.41, 0.52, 0.9), Vec3(0.5, 0.5, 0.3), Vec3(0.4, 0.75, 0.6)}) {
      const double r = std::hypot(point.x() - 0.4, point.y() - 0.5) / 0.2;
      const double profile = shape == gaussian ? std::exp(-2 * r * r) : r < 1 ? 1 : 0;
      const LightAtPoint light = lights.at({locator.find(point).front().cell, point}, std::nullopt);
      EXPECT_NEAR(light.fluence[0], profile * std::exp(-2 * (1 - point.z())), 1e-10);
    }
  }
}

// In cells larger and smaller than the beam, a pencil too.
TEST(RoundBeam, IsAbsorbedInTheCellsItPasses) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  for (const BeamProfile::Shape shape : {disc, gaussian})
    for (const double radius : {0.14, 0.0005}) {
      const Problem problem = with_beam(mesh, shape, radius, 0.4, 0.53);
      const LightSetup lights(problem);
      const UncollidedField field = uncollided_field(lights.paths(), lights.sources(), 1);
      double absorbed = 0;
      for (std::size_t i = 0; i < field.fluence.size(); ++i)
        absorbed += 2 * field.fluence[i] * mesh.volumes()[i / 4] / 4;
      const double sent = profile_area(shape, radius);
      EXPECT_NEAR(absorbed / sent, 1 - std::exp(-2.0), 1e-5) << radius;
      double kept = 0;
      for (std::size_t i = 0; i < field.irradiance.size(); ++i)
        kept += field.irradiance[i] * mesh.area(FaceIndex(static_cast<std::int32_t>(i / 3))) / 3;
      EXPECT_NEAR(kept / sent, std::exp(-2.0), 1e-5) << radius;
    }
}

}  // namespace
}  // namespace etendue::round_beam_test
