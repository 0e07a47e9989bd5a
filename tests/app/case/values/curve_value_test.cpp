// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/curve_value.h"

#include <gtest/gtest.h>

#include "app/case/values/value_algebra.h"

namespace etendue::curve_value_test {
namespace {

const TemperatureCurve curves[] = {TemperatureCurve::Table{{300, 500, 1000, 1400}, {2, 4, -1, -1}},
                                   TemperatureCurve::Polynomial{{1, -0.5e-3, 0.25e-6}, 350, 1300}};

// The formula of a temperature and the number at that temperature are the same function, also beyond what is
// known.
TEST(CurveValue, IsTheSameAsAFormulaAndAsANumber) {
  const Vec3 at(0.5, 0.25, 0);
  for (const TemperatureCurve& curve : curves)
    for (const double kelvin :
         {1.0, 300.0, 349.0, 420.0, 500.0, 731.0, 1000.0, 1250.0, 1399.0, 1400.0, 5000.0}) {
      const Value formula = curve_value(curve, Value(Formula{std::to_string(kelvin) + " + x - 2*y"}));
      ASSERT_FALSE(is_number(formula));
      EXPECT_NEAR(coefficient_of(formula).at(at), curve.at(kelvin), 1e-12) << kelvin;
      const Value number = curve_value(curve, Value(kelvin));
      ASSERT_TRUE(is_number(number));
      EXPECT_EQ(std::get<double>(number), curve.at(kelvin));
    }
}

TEST(CurveValue, IsANumberWhereTheCurveIsConstant) {
  EXPECT_TRUE(is_number(curve_value(TemperatureCurve(2.5), Value(Formula{"300 + x"}))));
}

}  // namespace
}  // namespace etendue::curve_value_test
