// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/first_collided_default.h"

#include <gtest/gtest.h>

#include "tests/app/case/case_text.h"

namespace etendue::first_collided_default_test {
namespace {

const std::string box = "[[mesh.box]]\nregion = \"haze\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n[walls.\"*\"]\n";
const std::string spot =
    "[[light]]\nname = \"torch\"\nkind = \"spot\"\nposition = [0.5, 0.5, 0.9]\ndirection = [0, 0, -1]\n"
    "angle = 25\npower = 1\n";
const std::string directions = "[directions]\norder = 2\n";

std::string haze(const std::string& g, const std::string& keys = "scattering = 1\n") {
  return "[media.haze]\n" + keys + "phase = { model = \"henyey-greenstein\", g = " + g + " }\n";
}

bool is_chosen(const std::string& text, const Overrides& overrides = {}) {
  return case_of(box + text, overrides).first_collided.has_value();
}

// The lobe of g = 0.79 has the half width of the distance of 384 directions, 10.4 degrees; that of g = 0.62
// the one of 96 directions, 20.7 degrees.
TEST(FirstCollidedDefault, IsThatOfSpotsInNarrowLobes) {
  EXPECT_TRUE(is_chosen(directions + spot + haze("0.8")));
  EXPECT_FALSE(is_chosen(directions + spot + haze("0.78")));
  EXPECT_TRUE(is_chosen(spot + haze("0.66")));
  EXPECT_FALSE(is_chosen(spot + haze("0.6")));
  EXPECT_FALSE(is_chosen(spot + haze("-0.9")));
  const Case chosen = case_of(box + directions + spot + haze("0.9"));
  ASSERT_TRUE(chosen.first_collided);
  EXPECT_EQ(chosen.first_collided->set, "ldfe-sq");
  EXPECT_EQ(chosen.first_collided->order, 4);
  EXPECT_EQ(
      chosen.first_collided->reason,
      "torch shines into a medium that turns light by less than 4.7 degrees (half width), and the directions "
      "are 10 degrees apart");
}

TEST(FirstCollidedDefault, LeavesOtherLightsAndMedia) {
  EXPECT_FALSE(is_chosen(directions + haze("0.9")));
  EXPECT_FALSE(is_chosen(directions + spot + "[media.haze]\nabsorption = 1\n"));
  EXPECT_FALSE(is_chosen(directions + spot + "uncollided = false\n" + haze("0.9")));
  const std::string lamp =
      "[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.9]\npower = 1\n";
  EXPECT_FALSE(is_chosen(directions + lamp + haze("0.9")));
  EXPECT_TRUE(is_chosen(directions + lamp + spot + haze("0.9")));
}

TEST(FirstCollidedDefault, LeavesWhatTheCaseChooses) {
  const std::string scene = spot + haze("0.9");
  EXPECT_FALSE(is_chosen(directions + "first_collided = { set = \"none\" }\n" + scene));
  EXPECT_EQ(case_of(box + directions + "first_collided = { order = 3 }\n" + scene).first_collided->order, 3);
  EXPECT_FALSE(is_chosen(scene, {"directions.order=4"}));
  EXPECT_FALSE(is_chosen(scene, {"directions.set=\"product\"", "directions.order=8"}));
  EXPECT_FALSE(
      is_chosen(directions + "refine = { direction = [0, 0, 1], angle = 10, levels = 1 }\n" + scene));
  EXPECT_FALSE(is_chosen(directions + spot + haze("0.9", "scattering = 1\nscattering_method = \"dense\"\n")));
  EXPECT_TRUE(
      is_chosen(directions + spot + haze("0.9", "scattering = 1\nscattering_method = \"moments\"\n")));
}

TEST(FirstCollidedDefault, IsOfOrdinatesOnly) {
  EXPECT_FALSE(is_chosen(directions + spot + haze("0.9"), {"solve.method=\"photons\""}));
  EXPECT_FALSE(is_chosen(directions + spot + haze("0.9"), {"output.fields=[\"radiance:3\"]"}));
}

}  // namespace
}  // namespace etendue::first_collided_default_test
