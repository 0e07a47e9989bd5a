// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/medium_coefficients.h"

#include <gtest/gtest.h>

#include <numbers>

#include "base/expression/expression.h"

namespace etendue::medium_coefficients_test {
namespace {

BandValues values(std::vector<Value> values) { return {std::move(values), {}}; }
double number(const Value& value) { return std::get<double>(value); }

double at(const Value& formula, double x) {
  const std::array<double, 3> point = {x, 0, 0};
  return Expression(std::get<Formula>(formula), {"x", "y", "z"})(point);
}

TEST(MediumCoefficients, TakeAlbedoOfExtinction) {
  MediumCase medium;
  medium.extinction = values({2.0, 4.0});
  medium.albedo = values({0.25});
  EXPECT_EQ(number(matter_values(medium, 1).scattering), 1);
  EXPECT_EQ(number(matter_values(medium, 1).absorption), 3);
}

TEST(MediumCoefficients, TakeTheDifferenceToExtinction) {
  MediumCase medium;
  medium.extinction = values({2.0});
  medium.scattering = values({0.5});
  EXPECT_EQ(number(matter_values(medium, 0).absorption), 1.5);
  medium.scattering.reset();
  medium.absorption = values({0.5});
  EXPECT_EQ(number(matter_values(medium, 0).scattering), 1.5);
}

TEST(MediumCoefficients, OfRoundedEqualsLeaveNothing) {
  MediumCase medium;
  medium.extinction = values({0.3});
  medium.scattering = values({0.1 + 0.2});
  EXPECT_EQ(number(matter_values(medium, 0).absorption), 0);
  EXPECT_EQ(matter_problem(medium, 0), "");
}

TEST(MediumCoefficients, ExtinctionAloneAbsorbsAndScatteringAloneScatters) {
  MediumCase absorber, scatterer;
  absorber.extinction = values({2.0});
  scatterer.scattering = values({3.0});
  EXPECT_EQ(number(matter_values(absorber, 0).absorption), 2);
  EXPECT_EQ(number(matter_values(absorber, 0).scattering), 0);
  EXPECT_EQ(number(matter_values(scatterer, 0).absorption), 0);
  EXPECT_EQ(number(matter_values(scatterer, 0).scattering), 3);
}

TEST(MediumCoefficients, CombineFormulas) {
  MediumCase medium;
  medium.extinction = values({"1 + x"});
  medium.albedo = values({0.25});
  EXPECT_DOUBLE_EQ(at(matter_values(medium, 0).scattering, 3), 1);
  EXPECT_DOUBLE_EQ(at(matter_values(medium, 0).absorption, 3), 3);
  medium.albedo = values({"x/4"});
  EXPECT_DOUBLE_EQ(at(matter_values(medium, 0).scattering, 3), 3);
  EXPECT_DOUBLE_EQ(at(matter_values(medium, 0).absorption, 3), 1);
}

TEST(MediumCoefficients, AcceptThreeThatAgree) {
  MediumCase medium;
  medium.extinction = values({0.3});
  medium.absorption = values({0.1});
  medium.scattering = values({0.2});
  EXPECT_EQ(matter_problem(medium, 0), "");
}

TEST(MediumCoefficients, CannotCompareFormulas) {
  MediumCase medium;
  medium.extinction = values({"x"});
  medium.absorption = values({"x"});
  medium.scattering = values({0.0});
  EXPECT_EQ(matter_problem(medium, 0),
            "too many coefficients (extinction follows from absorption + scattering, and formulas cannot be "
            "compared); "
            "leave one out");
}

TEST(MediumCoefficients, PowerDensityIsFourPiEmission) {
  MediumCase medium;
  medium.power_density = values({4 * std::numbers::pi, "x"});
  EXPECT_DOUBLE_EQ(number(emission_value(medium, 0)), 1);
  EXPECT_DOUBLE_EQ(at(emission_value(medium, 1), 4 * std::numbers::pi), 1);
}

}  // namespace
}  // namespace etendue::medium_coefficients_test
