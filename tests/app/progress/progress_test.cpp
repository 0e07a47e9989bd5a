// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/progress/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

namespace etendue::progress_test {
namespace {

/// Shows sweeps of a tenth of a second each, the residual falling by ten.
std::string shown(ProgressStyle style, int sweeps, double seconds_left = 3) {
  std::ostringstream out;
  ProgressDisplay display(style, out);
  double residual = 1;
  for (int sweep = 1; sweep <= sweeps; ++sweep, residual /= 10) {
    const std::array<double, 2> residuals = {residual / 2, residual};
    display.show({sweep, 500, residuals, 1e-4, 0.1 * sweep, seconds_left});
  }
  display.finish();
  return out.str();
}

TEST(Progress, PlainLinesComeAtIntervalsAndForTheFirstAndLastSweep) {
  const std::string text = shown(ProgressStyle::plain, 60);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);  // at 0.1, 5.1 and 6 seconds
  EXPECT_EQ(text.rfind("  sweep    1  residual 1.00e+00  tolerance 1e-04  0.1 s, about 3.0 s left\n", 0), 0U)
      << text;
  EXPECT_NE(text.find("sweep   60"), std::string::npos);
}

TEST(Progress, PlainShowsASingleSweepOnce) {
  const std::string text = shown(ProgressStyle::plain, 1);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(Progress, SaysNothingOfATimeThatIsNotKnown) {
  EXPECT_EQ(shown(ProgressStyle::plain, 1, -1).find("left"), std::string::npos);
}

TEST(Progress, BarFillsWithTheLogarithmOfTheResidual) {
  const std::string text = shown(ProgressStyle::bar, 3);  // from 1 to 1e-2 on the way to 1e-4
  EXPECT_NE(text.find("[############............]  sweep    3"), std::string::npos) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 3);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(Progress, BarIsFullAtTheTolerance) {
  EXPECT_NE(shown(ProgressStyle::bar, 6).find("[########################]  sweep    6"), std::string::npos);
}

TEST(Progress, BarBearsAResidualThatGrowsOrIsNotANumber) {
  std::ostringstream out;
  ProgressDisplay display(ProgressStyle::bar, out);
  for (const double residual : {1.0, 10.0, std::numeric_limits<double>::quiet_NaN()}) {
    const std::array<double, 1> residuals = {residual};
    display.show({1, 500, residuals, 1e-4, 0, -1});
  }
  EXPECT_NE(out.str().find("nan"), std::string::npos);
}

TEST(Progress, NoneShowsNothing) { EXPECT_EQ(shown(ProgressStyle::none, 5), ""); }

TEST(Progress, IsPlainWhereThereIsNoTerminal) {
  const std::ostringstream out;
  EXPECT_EQ(resolved_style(ProgressStyle::automatic, out), ProgressStyle::plain);
  EXPECT_EQ(resolved_style(ProgressStyle::bar, out), ProgressStyle::bar);
}

}  // namespace
}  // namespace etendue::progress_test
