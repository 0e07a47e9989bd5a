// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Lights of kind "beam": fibres against closed forms, and where beams are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "app/case/build/build.h"
#include "app/case/build/round_beam.h"
#include "base/errors.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/photons/solve/solve_photons.h"
#include "solver/problem/mirror.h"
#include "solver/uncollided/lights/light_setup.h"
#include "solver/uncollided/projection/light_at_wall.h"
#include "tests/app/case/case_text.h"

namespace etendue::beam_test {
namespace {

using std::numbers::pi;

constexpr double absorption = 0.8, radius = 0.12, aperture = 0.5;

/// A unit cube of gel below a surface, with a light of kind "beam" straight down through it.
std::string gel(const std::string& index, const std::string& keys) {
  return "[mesh]\nmax_volume = 0.05\n[[mesh.box]]\nregion = \"gel\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
         "walls = { zmax = \"surface\" }\n[media.gel]\nabsorption = 0.8\n[walls.surface]\nrefractive_index "
         "= " +
         index +
         "\n[walls.\"*\"]\n[[light]]\nname = \"fibre\"\nkind = \"beam\"\npower = 2\nradius = 0.12\n"
         "direction = [0, 0, -1]\nwalls = [\"surface\"]\n" +
         keys;
}

struct Built {
  explicit Built(const std::string& text) : input(case_of(text)), mesh(build_mesh(input)) {}
  Case input;
  TetrahedralMesh mesh;
  Problem problem = build_problem(input, mesh);
};

/// Mean of a function of the cosines outside and inside over the projected solid angle of the cone.
template <class Function>
double mean_over_cone(double index, Function&& function) {
  constexpr int count = 20000;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double square = aperture * aperture * (i + 0.5) / count;
    sum += function(std::sqrt(1 - square), std::sqrt(1 - square / (index * index)));
  }
  return sum / count;
}

double let_in(double index, double cosine) { return 1 - fresnel_reflectance(cosine, 1 / index); }

// With the same radiance L in all of the cone, the power is L A pi NA^2.
TEST(Fibre, SendsWhatFresnelLetsIn) {
  for (const double index : {1.0, 1.4}) {
    const Built built(gel(std::to_string(index), "position = [0.5, 0.5, 1]\nnumerical_aperture = 0.5\n"));
    double entering = 0;
    const LightSetup lights(built.problem);
    for (const auto& source : lights.sources()) entering += source->power()[0];
    const double expected =
        mean_over_cone(index, [&](double outside, double) { return let_in(index, outside); });
    EXPECT_NEAR(entering / 2, expected, 1e-5);
  }
}

// exp(-sigma/cos) of the light comes to the bottom, all of which the cone behind a surface meets.
TEST(Fibre, GoesThroughTheGelByRaysAndByPhotons) {
  const double index = 1.4;
  const Built built(gel("1.4", "position = [0.5, 0.5, 1]\nnumerical_aperture = 0.5\n"));
  const double through = 2 * mean_over_cone(index, [&](double outside, double inside) {
                           return let_in(index, outside) * std::exp(-absorption / inside);
                         });
  const LightSetup lights(built.problem);
  double by_rays = 0;
  for (const auto& source : lights.sources())
    for (const Wall& wall : built.problem.walls())
      by_rays += source->power()[0] * part_at_wall(lights.paths(), lights.shadow_edges(), *source, wall);
  EXPECT_NEAR(by_rays / through, 1, 1e-4);
  PhotonOptions options;
  options.photons = 1e4;
  options.threads = 2;
  const CellLocator locator(built.mesh);
  const Solution photons = solve_photons(built.problem, locator, options).solution;
  double by_photons = 0;
  for (std::int32_t f = 0; f < built.mesh.boundary_face_count(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      by_photons += photons.irradiance[3 * FaceIndex(f).at() + i] * built.mesh.area(FaceIndex(f)) / 3;
  EXPECT_NEAR(by_photons / through, 1, 2e-3);
}

// On the axis at a depth z the tip fills the cone with the tangent R/z, or all of the cone of the fibre.
TEST(Fibre, LightsItsAxis) {
  const double index = 1.4;
  const Built built(gel("1.4", "position = [0.5, 0.5, 1]\nnumerical_aperture = 0.5\n"));
  const LightSetup lights(built.problem);
  const CellLocator locator(built.mesh);
  const double radiance = 2 / (pi * radius * radius * pi * aperture * aperture);
  for (const double depth : {0.1, 0.25, 0.4, 0.7}) {
    const Vec3 point(0.5, 0.5, 1 - depth);
    // In the gel the radiance is n^2 times that outside, and dw_in cos_in n^2 = dw_out cos_out.
    const double expected =
        pi * aperture * aperture * radiance * mean_over_cone(index, [&](double outside, double inside) {
          const bool seen = depth * std::sqrt(1 - inside * inside) / inside < radius;
          return seen ? let_in(index, outside) * std::exp(-absorption * depth / inside) / inside : 0;
        });
    const double found = lights.at({locator.find(point).front().cell, point}, std::nullopt).fluence[0];
    // Of the 128 directions those near the edge of what is seen count whole or not.
    EXPECT_NEAR(found / expected, 1, depth < 0.2 ? 1e-4 : 0.06) << depth;
  }
}

std::string faults_of(const std::string& text) {
  try {
    const Built built(text);
    return "";
  } catch (const InputError& error) {
    return error.faults().front().text;
  }
}

TEST(Beam, IsRefusedWhereItBeginsInside) {
  EXPECT_EQ(faults_of(gel("1.4", "position = [0.5, 0.5, 1]\n")), "");
  EXPECT_NE(faults_of(gel("1.4", "position = [0.5, 0.5, 0.8]\n"))
                .find("the light \"fibre\" begins inside the domain at [0.5, 0.5, 0.8]"),
            std::string::npos);
}

// Down through the upper of two boxes with a gap between them: both tops are one wall.
TEST(Beam, IsRefusedWhereItComesInTwice) {
  const std::string stack =
      "[mesh]\nmax_volume = 0.1\n[[mesh.box]]\nregion = \"gel\"\nmin = [0, 0, 0]\nmax = [3, 1, 1]\n"
      "walls = { zmax = \"surface\" }\n[[mesh.box]]\nregion = \"gel\"\nmin = [0, 0, 1]\nmax = [1, 1, 3]\n"
      "walls = { zmax = \"surface\" }\n[[mesh.box]]\nregion = \"gel\"\nmin = [1, 0, 2]\nmax = [3, 1, 3]\n"
      "walls = { zmax = \"surface\" }\n[media.gel]\nabsorption = 1\n[walls.\"*\"]\n"
      "[[light]]\nname = \"laser\"\nkind = \"beam\"\npower = 1\nradius = 0.1\ndirection = [0, 0, -1]\n"
      "walls = [\"surface\"]\nposition = ";
  EXPECT_EQ(faults_of(stack + "[0.5, 0.5, 4]\n"), "");
  EXPECT_NE(faults_of(stack + "[2, 0.5, 4]\n").find("passes through its walls more than once (with 2 of"),
            std::string::npos);
}

// A disc of which a side of the cube cuts off the segment beyond half of its radius.
TEST(Beam, KnowsThePartThatReachesItsWalls) {
  const Built built(gel("1.4", "position = [0.94, 0.5, 2]\n"));
  const LightCase& light = built.input.lights.front();
  const double expected = 1 - (pi / 3 - std::sqrt(3.0) / 4) / pi;
  EXPECT_NEAR(part_on_walls(light, built.problem.lights(), built.mesh), expected, 1e-4);
}

}  // namespace
}  // namespace etendue::beam_test
