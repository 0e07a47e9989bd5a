// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/unit_labels.h"

#include <gtest/gtest.h>

namespace etendue::unit_labels_test {
namespace {

TEST(UnitLabels, AreMadeFromLengthAndPower) {
  const UnitLabels units(Units{"cm", "mW"});
  EXPECT_EQ(units.flux, "mW/cm^2");
  EXPECT_EQ(units.radiance, "mW/(cm^2 sr)");
  EXPECT_EQ(units.emission, "mW/(cm^3 sr)");
  EXPECT_EQ(units.coefficient, "1/cm");
  EXPECT_EQ(units.volume, "cm^3");
}

TEST(UnitLabels, PutParticleCountsUnderOneFraction) {
  const UnitLabels units(Units{"m", "1/s"});
  EXPECT_EQ(units.flux, "1/(s m^2)");
  EXPECT_EQ(units.radiance, "1/(s m^2 sr)");
}

}  // namespace
}  // namespace etendue::unit_labels_test
