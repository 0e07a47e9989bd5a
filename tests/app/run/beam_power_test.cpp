// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "tests/app/run/small_case.h"

namespace etendue::beam_power_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;

/// A disc of 2 W and radius 0.2 that comes down into a unit cube at x.
std::string said(const std::string& x, const std::string& walls,
                 const std::string& entry = "walls = [\"zmax\"]\n") {
  const CaseFolder folder(
      "[mesh]\nmax_volume = 0.1\n[[mesh.box]]\nregion = \"gel\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
      "[media.gel]\nabsorption = 1\n[walls.\"*\"]\n" +
      walls +
      "[[light]]\nname = \"laser\"\nkind = \"beam\"\npower = 2\nradius = 0.2\ndirection = [0, 0, -1]\n" +
      entry + "position = [" + x + ", 0.5, 1]\n");
  const Outcome outcome = etendue_says({"check", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  return outcome.out;
}

TEST(BeamPower, IsThatOfTheWholeBeamOnItsWalls) {
  const std::string out = said("0.5", "");
  EXPECT_TRUE(has(out, "beam laser: 2 of 2 W comes in\n")) << out;
  EXPECT_FALSE(has(out, "caution")) << out;
}

// Half of it, without a mirror and with one in which its axis lies.
TEST(BeamPower, TellsWhatMissesTheWallsFromASymmetryPlane) {
  const std::string cut = said("1", "");
  EXPECT_TRUE(has(cut,
                  "beam laser: 1 of 2 W comes in\n"
                  "caution: beam laser: 50 % of its power passes beside its walls"))
      << cut;
  const std::string symmetric = said("1", "[walls.xmax]\nspecular = 1\n");
  EXPECT_TRUE(has(symmetric, "beam laser: 1 of 2 W comes in, 1 is that behind the symmetry planes\n"))
      << symmetric;
  EXPECT_FALSE(has(symmetric, "caution")) << symmetric;
}

// Fresnel's formulas for normal incidence: 1 - (0.5/2.5)^2 comes in.
TEST(BeamPower, LeavesOutWhatTheSurfaceReflects) {
  const std::string out = said("0.5", "[walls.zmax]\nrefractive_index = 1.5\n");
  EXPECT_TRUE(has(out, "beam laser: 1.92 of 2 W comes in, 0.08 is reflected or absorbed by its walls"))
      << out;
}

// It meets zmax alone, though xmin refracts too.
TEST(BeamPower, ComesInByTheWallThatItMeetsWhereNoneIsNamed) {
  const std::string out =
      said("0.5", "[walls.xmin]\nrefractive_index = 1.5\n[walls.zmax]\nrefractive_index = 1.5\n", "");
  EXPECT_TRUE(has(out, "beam laser: 1.92 of 2 W comes in")) << out;
}

}  // namespace
}  // namespace etendue::beam_power_test
