// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/solver/problem/cube_mesh.h"

namespace etendue::problem_test {
namespace {

/// Two bands on the cube: an emitting, absorbing, scattering medium between black walls.
struct Asked {
  Bands bands{{"red", "blue"}, {}};
  std::vector<Medium> media;
  std::vector<Wall> walls;

  Asked() {
    int line = 10;
    for (const char* name : {"left", "right"}) {
      const std::string key = std::string("media.") + name;
      media.push_back({name,
                       {0.1, 0.2},
                       {1.0, 2.0},
                       {0.5, 0.0},
                       {PhaseIsotropic{}, PhaseIsotropic{}},
                       {"room.toml", line++, key}});
    }
    for (const char* name : {"floor", "rest"}) {
      const std::string key = std::string("walls.") + name;
      walls.push_back({name, {0, 0}, {0, 0}, {0, 0}, {"room.toml", line++, key}});
    }
  }
};

Coefficient formula(const std::string& text) { return Coefficient(Expression(text, {"x", "y", "z"})); }

std::string message_of(const Asked& asked, AngularSpace space = AngularSpace::sphere) {
  const TetrahedralMesh mesh = cube_mesh();
  try {
    Problem(mesh, asked.bands, asked.media, asked.walls, space);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Problem, HoldsTheCoefficientsOfEveryCellAndBand) {
  Asked asked;
  asked.media[1].absorption[1] = formula("1 + x");
  const TetrahedralMesh mesh = cube_mesh();
  const Problem problem(mesh, asked.bands, asked.media, asked.walls);
  ASSERT_EQ(problem.absorption().size(), 12u);
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const bool right = problem.medium(mesh.region(cell)).name == "right";
    EXPECT_EQ(problem.absorption(cell, 0), 0.1);
    EXPECT_NEAR(problem.absorption(cell, 1), right ? 1 + mesh.centroid(cell).x() : 0.2, 1e-15);
    EXPECT_EQ(problem.scattering(cell, 1), 2.0);
    EXPECT_EQ(problem.emission(cell, 0), 0.5);
  }
  EXPECT_EQ(problem.wall(1).name, "rest");
  EXPECT_EQ(problem.band_count(), 2);
}

TEST(Problem, IsTheSameForAnyNumberOfThreads) {
  Asked asked;
  asked.media[0].absorption[0] = formula("1 + sin(9*x*y) + z");
  asked.media[1].scattering[1] = formula("exp(x - y)");
  asked.media[0].emission[1] = formula("x*x + z");
  const TetrahedralMesh mesh = cube_mesh();
  const auto sampled_by = [&](int threads) {
    return Problem(mesh, asked.bands, asked.media, asked.walls, AngularSpace::sphere, {}, threads);
  };
  const Problem one = sampled_by(1);
  for (const int threads : {2, 5}) {
    const Problem several = sampled_by(threads);
    EXPECT_TRUE(std::ranges::equal(one.absorption(), several.absorption()));
    EXPECT_TRUE(std::ranges::equal(one.scattering(), several.scattering()));
    for (int c = 0; c < mesh.cell_count(); ++c)
      EXPECT_EQ(one.emission(CellIndex(c), 1), several.emission(CellIndex(c), 1));
  }
}

TEST(Problem, NamesTheFirstNegativePointOfACoefficient) {
  Asked asked;
  asked.media[0].scattering[1] = formula("z < 2 ? -1 : 0");
  const std::string message = message_of(asked);
  EXPECT_EQ(message.find("room.toml:10: media.left.scattering = -1: negative at (0."), 0u) << message;
  EXPECT_NE(message.find(") (band blue); must be a finite number of at least 0 in the whole region"),
            std::string::npos)
      << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Problem, RefusesAFormulaThatIsNegativeInACornerThoughItsMeanIsNot) {
  Asked asked;
  asked.media[0].absorption[0] = formula("y - 0.12");
  EXPECT_NE(message_of(asked).find("media.left.absorption"), std::string::npos);
}

TEST(Problem, RefusesNumbersThatAreNotFinite) {
  Asked asked;
  asked.media[1].absorption[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of(asked),
            "room.toml:11: media.right.absorption = nan: not a finite number (band red); must be a finite "
            "number of "
            "at least 0 in the whole region");
  asked.media[1].absorption[0] = formula("1/(x-x)");
  EXPECT_NE(message_of(asked).find("media.right.absorption = inf: not a finite number at ("),
            std::string::npos);
}

TEST(Problem, RefusesNegativeConstantsOfEveryKindAtOnce) {
  Asked asked;
  asked.media[0].absorption[0] = -0.5;
  asked.media[0].emission[1] = -2;
  asked.media[1].scattering[0] = -1e-9;
  EXPECT_EQ(message_of(asked),
            "room.toml:10: media.left.absorption = -0.5: negative (band red); must be a finite number of at "
            "least 0 "
            "in the whole region\n"
            "room.toml:10: media.left.emission = -2: negative (band blue); must be a finite number of at "
            "least 0 in "
            "the whole region\n"
            "room.toml:11: media.right.scattering = -1e-09: negative (band red); must be a finite number of "
            "at least "
            "0 in the whole region");
}

TEST(Problem, RefusesAsymmetriesThatAreNoPhaseFunction) {
  Asked asked;
  asked.media[0].phase[1] = PhaseHenyeyGreenstein{1};
  EXPECT_EQ(message_of(asked),
            "room.toml:10: media.left.phase.g = 1: no phase function (band blue); give a mean cosine between "
            "-1 and "
            "1, both excluded");
}

TEST(Problem, RefusesWallsThatReflectMoreThanArrives) {
  Asked asked;
  asked.walls[0].diffuse[0] = 0.7;
  asked.walls[0].specular[0] = 0.4;
  EXPECT_EQ(message_of(asked),
            "room.toml:12: walls.floor.diffuse + specular = 1.1: reflects more light than arrives (band "
            "red); give at "
            "most 1 together");
  asked.walls[0].specular[0] = 0.3;
  EXPECT_EQ(message_of(asked), "");
}

TEST(Problem, RefusesWallNumbersOutOfRange) {
  Asked asked;
  asked.walls[1].radiance[0] = -1;
  asked.walls[1].diffuse[1] = 1.5;
  EXPECT_EQ(
      message_of(asked),
      "room.toml:13: walls.rest.radiance = -1: out of range (band red); give a finite number of at least 0\n"
      "room.toml:13: walls.rest.diffuse = 1.5: out of range (band blue); give a number from 0 to 1");
}

TEST(Problem, RefusesABandWithoutSteadyState) {
  Asked asked;
  for (Medium& medium : asked.media) medium.absorption[0] = 0;
  for (Wall& wall : asked.walls) wall.specular[0] = 1;
  EXPECT_EQ(
      message_of(asked),
      "room.toml:10: media.left.emission: no steady state in band red (light is emitted, nothing absorbs and "
      "every wall reflects fully); give a medium absorption or a wall a reflectance below 1");
  for (Medium& medium : asked.media) medium.emission[0] = 0;
  EXPECT_EQ(message_of(asked), "");  // dark: zero is the solution
  asked.walls[1].radiance[0] = 1;
  EXPECT_EQ(message_of(asked).find("room.toml:13: walls.rest.radiance: no steady state in band red"), 0u);
  asked.walls[0].specular[0] = 0.999;
  EXPECT_EQ(message_of(asked), "");
}

TEST(Problem, AsksForAMediumPerRegionAndAWallPerWall) {
  Asked asked;
  asked.media.pop_back();
  EXPECT_THROW(message_of(asked), std::invalid_argument);
  asked = Asked();
  asked.walls[0].diffuse.pop_back();
  EXPECT_THROW(message_of(asked), std::invalid_argument);
}

TEST(Problem, OfThePlaneAsksForColdMirrorsAcrossZ) {
  Asked asked;
  const std::string black = message_of(asked, AngularSpace::plane);
  EXPECT_NE(black.find("room.toml:12: walls.floor.specular: the wall at ("), std::string::npos) << black;
  EXPECT_NE(black.find("faces along z and is no cold mirror (nothing in flatland depends on z)"),
            std::string::npos)
      << black;
  for (Wall& wall : asked.walls) wall.specular = {1, 1};
  asked.walls[0].radiance = {0, 0.1};
  EXPECT_NE(message_of(asked, AngularSpace::plane).find("use specular = 1 and no radiance for it"),
            std::string::npos);
  asked.walls[0].radiance = {0, 0};
  EXPECT_EQ(message_of(asked, AngularSpace::plane), "");
}

TEST(Problem, OfThePlaneTurnsPhaseFunctionsIntoThoseOfThePlane) {
  Asked asked;
  for (Wall& wall : asked.walls) wall.specular = {1, 1};
  asked.media[0].phase[0] = PhaseHenyeyGreenstein{0.6};
  const TetrahedralMesh mesh = cube_mesh();
  const Problem problem(mesh, asked.bands, asked.media, asked.walls, AngularSpace::plane);
  EXPECT_EQ(problem.medium(0).phase[0], in_plane(PhaseHenyeyGreenstein{0.6}));
}

TEST(Problem, OfSomeBandsHasTheirCoefficientsAlone) {
  const TetrahedralMesh mesh = cube_mesh();
  Asked asked;
  asked.walls[0].diffuse = {0.25, 0.5};
  asked.media[1].choice = {{ScatteringBackend::moments, 3}, {ScatteringBackend::dense, 0}};
  PointLight lamp;
  lamp.power = {3, 4};
  const Problem both(mesh, asked.bands, asked.media, asked.walls, AngularSpace::sphere, {{"lamp", lamp, {}}});
  const int wanted[] = {1};
  const Problem blue = both.of_bands(wanted);
  EXPECT_EQ(blue.band_count(), 1);
  EXPECT_EQ(blue.bands().names[0], "blue");
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    EXPECT_EQ(blue.absorption(CellIndex(c), 0), both.absorption(CellIndex(c), 1));
    EXPECT_EQ(blue.scattering(CellIndex(c), 0), both.scattering(CellIndex(c), 1));
    EXPECT_EQ(blue.emission(CellIndex(c), 0), both.emission(CellIndex(c), 1));
  }
  EXPECT_EQ(blue.absorption().size(), static_cast<std::size_t>(mesh.cell_count()));
  EXPECT_EQ(blue.wall(0).diffuse, std::vector<double>{0.5});
  EXPECT_EQ(blue.medium(1).choice_of(0).backend, ScatteringBackend::dense);
  EXPECT_TRUE(blue.medium(0).choice.empty()) << "what is the same for all bands stays so";
  EXPECT_EQ(std::get<PointLight>(blue.lights()[0].kind).power, std::vector<double>{4});
}

TEST(Problem, OfSomeBandsEmitsWhatFollowsInThem) {
  const TetrahedralMesh mesh = cube_mesh();
  Problem both(mesh, Asked().bands, Asked().media, Asked().walls);
  const CellIndex cell(3);
  const FaceIndex face(5);
  FollowingSources sources{CellEmission(static_cast<std::size_t>(mesh.cell_count()), 2),
                           std::vector<double>(static_cast<std::size_t>(mesh.boundary_face_count()) * 6, 0)};
  sources.cells.add(cell, 1, 7, {1, -1, 2, -2});
  for (std::size_t i = 0; i < 3; ++i)
    sources.radiance[face.at() * 6 + 2 * i + 1] = static_cast<double>(i + 1);
  const double own = both.emission(cell, 1);
  both.set_following(sources);
  const int wanted[] = {1};
  const Problem one = both.of_bands(wanted);
  EXPECT_EQ(one.emission(cell, 0), own + 7);
  EXPECT_EQ(one.following_radiance(face, 2, 0), 3);
  EXPECT_EQ(one.following_radiance(face, 0), 2);
  EXPECT_EQ(both.following_radiance(face, 0), 0);
  both.set_following({});
  EXPECT_EQ(both.emission(cell, 1), own);
  EXPECT_EQ(both.following_radiance(face, 2, 1), 0);
}

TEST(Problem, EmitsLinearlyWithinCells) {
  const TetrahedralMesh mesh = cube_mesh();
  Asked asked;
  asked.media[1].emission = {formula("1 + x"), Coefficient(0.5)};
  const Problem problem(mesh, asked.bands, asked.media, asked.walls);
  const int wanted[] = {1, 0};
  const Problem turned = problem.of_bands(wanted);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const bool right = problem.medium(mesh.region(cell)).name == "right";
    EXPECT_EQ(problem.cell_emission().varies_in(cell), right);
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = mesh.point(VertexIndex(mesh.vertices(cell)[i])).x();
      EXPECT_NEAR(problem.cell_emission().at(cell, 0, i), right ? 1 + x : 0.5, 1e-14);
      EXPECT_EQ(problem.cell_emission().at(cell, 1, i), right ? 0.5 : 0);
      EXPECT_EQ(turned.cell_emission().at(cell, 1, i), problem.cell_emission().at(cell, 0, i));
      EXPECT_EQ(turned.cell_emission().at(cell, 0, i), problem.cell_emission().at(cell, 1, i));
    }
  }
}

// A medium as warm everywhere is in balance with its walls in each cell, whatever its absorption.
TEST(Problem, EmitsTheMeanAbsorptionTimesTheBlackbody) {
  const TetrahedralMesh mesh = cube_mesh();
  Asked asked;
  for (Medium& medium : asked.media) {
    medium.absorption[0] = formula("1 + x^2");
    medium.emission[0] = Coefficient(0.0);
    medium.blackbody = {Coefficient(3.0), formula("2 + y")};
  }
  const Problem problem(mesh, asked.bands, asked.media, asked.walls);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    EXPECT_DOUBLE_EQ(problem.emission(cell, 0), 3 * problem.absorption(cell, 0));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_DOUBLE_EQ(problem.cell_emission().at(cell, 0, i), 3 * problem.absorption(cell, 0));
      EXPECT_NEAR(problem.cell_emission().at(cell, 1, i),
                  problem.absorption(cell, 1) * (2 + mesh.point(VertexIndex(mesh.vertices(cell)[i])).y()),
                  1e-14);
    }
  }
}

}  // namespace
}  // namespace etendue::problem_test
