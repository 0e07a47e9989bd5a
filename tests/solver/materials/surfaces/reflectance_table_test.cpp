// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/reflectance_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue::reflectance_table_test {
namespace {

using std::numbers::pi;

std::vector<ReflectancePoint> grid(double (*value)(double, double, double)) {
  std::vector<ReflectancePoint> points;
  for (const double in : {10., 45., 80.})
    for (const double out : {10., 45., 80.})
      for (const double azimuth : {0., 180.}) points.push_back({in, out, azimuth, value(in, out, azimuth)});
  return points;
}

TEST(ReflectanceTable, AConstantIsLambert) {
  const auto points = grid([](double, double, double) { return 1 / pi; });
  EXPECT_EQ(ReflectanceTable::problem_of(points), "");
  const ReflectanceTable table(points, 0.5);
  for (const double cosine : {0.01, 0.5, 1.0}) {
    EXPECT_NEAR(table.albedo(cosine), 0.5, 1e-12);
    EXPECT_NEAR(table.value(cosine, 0.3, 0.2), 0.5 / pi, 1e-15);
  }
}

TEST(ReflectanceTable, IsLinearBetweenPoints) {
  const auto points = grid([](double in, double out, double azimuth) { return in * out * (1 + azimuth); });
  const ReflectanceTable table(points, 1);
  const auto at = [&](double in, double out, double azimuth) {
    const double i = in * pi / 180, o = out * pi / 180, a = azimuth * pi / 180;
    return table.value(std::cos(i), std::cos(o),
                       std::cos(i) * std::cos(o) + std::sin(i) * std::sin(o) * std::cos(a));
  };
  EXPECT_NEAR(at(20, 60, 90), 20 * 60 * 91., 1e-6);
  EXPECT_NEAR(at(5, 60, 90), 10 * 60 * 91., 1e-6);
}

TEST(ReflectanceTable, TellsWhatIsWrong) {
  const auto problem = [](std::vector<ReflectancePoint> points) {
    return ReflectanceTable::problem_of(points);
  };
  EXPECT_NE(problem({}).find("no points"), std::string::npos);
  EXPECT_NE(problem({{0, 95, 0, 1}}).find("out = 95"), std::string::npos);
  EXPECT_NE(problem({{0, 0, 0, -1}}).find("at least 0"), std::string::npos);
  EXPECT_NE(problem({{0, 0, 0, 1}, {0, 0, 0, 1}}).find("two values"), std::string::npos);
  EXPECT_NE(problem({{0, 10, 0, 1}, {0, 0, 0, 1}}).find("angles in and out differ"), std::string::npos);
  EXPECT_NE(problem({{0, 10, 0, 1}, {10, 0, 0, 1}}).find("no whole grid"), std::string::npos);
  const std::string one_way =
      problem(grid([](double in, double out, double) { return in > out ? 0.2 : 0.1; }));
  EXPECT_NE(
      one_way.find("not reciprocal: 0.2 at in = 45, out = 10, azimuth = 0 degrees and 0.1 the other way"),
      std::string::npos)
      << one_way;
}

// Readings that differ by a little are one value.
TEST(ReflectanceTable, MakesBothWaysEqual) {
  const auto points = grid([](double in, double out, double) { return in > out ? 0.101 : 0.1; });
  ASSERT_EQ(ReflectanceTable::problem_of(points), "");
  const ReflectanceTable table(points, 1);
  EXPECT_EQ(table.value(0.9, 0.4, 0.5), table.value(0.4, 0.9, 0.5));
}

}  // namespace
}  // namespace etendue::reflectance_table_test
