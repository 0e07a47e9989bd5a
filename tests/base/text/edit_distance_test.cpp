// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/text/edit_distance.h"

#include <gtest/gtest.h>

#include <vector>

namespace etendue::edit_distance_test {
namespace {

const std::vector<std::string> names = {"absorption", "scattering", "phase"};

TEST(EditDistance, CountsInsertionsDeletionsSubstitutionsAndSwaps) {
  EXPECT_EQ(edit_distance("phase", "phase"), 0);
  EXPECT_EQ(edit_distance("phse", "phase"), 1);
  EXPECT_EQ(edit_distance("phaase", "phase"), 1);
  EXPECT_EQ(edit_distance("phaze", "phase"), 1);
  EXPECT_EQ(edit_distance("phaes", "phase"), 1);
  EXPECT_EQ(edit_distance("", "phase"), 5);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(EditDistance, TakesCapitalsForSmallLetters) { EXPECT_EQ(edit_distance("Phase", "phase"), 0); }

TEST(Suggestion, IsTheNearestName) {
  EXPECT_EQ(closest_name("scatering", names), "scattering");
  EXPECT_EQ(closest_name("absorbtion", names), "absorption");
}

TEST(Suggestion, IsEmptyWhereNothingIsNear) {
  EXPECT_EQ(closest_name("temperature", names), "");
  EXPECT_EQ(closest_name("x", std::vector<std::string>{"g"}), "");
}

TEST(Enumeration, EndsWithOr) {
  EXPECT_EQ(enumerate(names), "absorption, scattering or phase");
  EXPECT_EQ(enumerate(std::vector<std::string>{"g"}), "g");
}

}  // namespace
}  // namespace etendue::edit_distance_test
