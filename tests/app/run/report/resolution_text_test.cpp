// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/resolution_text.h"

#include <gtest/gtest.h>

namespace etendue::resolution_text_test {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(ResolutionText, SaysNothingOfAVacuum) { EXPECT_EQ(resolution_text({}, true), ""); }

TEST(ResolutionText, CautionsOnlyOfCellsAndDirectionsThatAreTooCoarse) {
  Resolution fine;
  fine.median_thickness = 0.5;
  fine.largest_thickness = 2;
  fine.transport_thickness_at_lights = 0.4;
  fine.direction_spacing = 0.2;
  fine.narrowest = {"tissue", 0.08};
  EXPECT_EQ(
      resolution_text(fine, true),
      "cells: 0.5 mean free paths thick (median), 2 at most; at lights 0.4 transport mean free paths\n");

  Resolution lumped = fine;
  lumped.transport_thickness_at_lights = 0;
  lumped.thick_count = 3;
  lumped.pair_count = 8;
  EXPECT_EQ(resolution_text(lumped, true),
            "cells: 0.5 mean free paths thick (median), 2 at most; mass lumped in 3 of 8 cells and bands "
            "(thicker than 2)\n");

  Resolution thick = fine;
  thick.transport_thickness_at_lights = 2.3;
  EXPECT_TRUE(
      has(resolution_text(thick, true), "caution: cells at lights are 2.3 transport mean free paths thick"));
  EXPECT_TRUE(has(resolution_text(thick, true), "mesh.max_volume), or solve.method = \"photons\""));
  EXPECT_FALSE(has(resolution_text(thick, false), "photons"));

  Resolution wide = fine;
  wide.direction_spacing = 0.36;
  EXPECT_TRUE(has(resolution_text(wide, true), "caution: directions are 21 degrees apart"));
  EXPECT_TRUE(has(resolution_text(wide, true), "tissue"));
  EXPECT_TRUE(has(resolution_text(wide, true), "use 406 directions or more"));
  wide.narrowest->half_width = 0.001;
  EXPECT_FALSE(has(resolution_text(wide, true), "directions or more"));
  EXPECT_TRUE(has(resolution_text(wide, true), "photons"));
}

}  // namespace
}  // namespace etendue::resolution_text_test
