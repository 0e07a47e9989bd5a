// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/run_report.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/write/sample_run.h"

namespace etendue {
namespace {

using test::SampleRun;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(RunReport, GivesChoicesAndConvergenceOfEachBand) {
  SampleRun run({"red", "green"});
  run.solution.convergence[1].converged = false;
  const std::string text = convergence_text(run.result());
  EXPECT_TRUE(has(text, "a choice (its reason)\n"));
  EXPECT_TRUE(has(text, "red         7  1.00e-09  converged\n")) << text;
  EXPECT_TRUE(has(text, "green       7  1.00e-09  NOT converged\n")) << text;
}

TEST(RunReport, GivesTheBalanceOfEachBand) {
  EXPECT_EQ(balance_text(SampleRun({"red", "green"}).result()),
            "\nbalance [W]: emitted + inflow = absorbed + outflow\n"
            "  band   emitted  inflow  absorbed  outflow  residual\n"
            "  red          1       2       1.5      1.5   0.0e+00\n"
            "  green        1       2       1.5      1.5   0.0e+00\n");
}

TEST(RunReport, SaysWhereEmittedPowerDiffersFromPi) {
  const SampleRun run({"grey"});
  RunResult result = run.result();
  EXPECT_FALSE(has(powers_text(result), "emits"));
  result.walls[0][0].emitted = 1.01;
  result.walls[0][0].emitted_exact = 1;
  EXPECT_TRUE(has(powers_text(result), "emits 1.01 W in band grey on these directions; pi L A = 1 (+1 %)"))
      << powers_text(result);
}

TEST(RunReport, PointsToTheFileWhereProbesAreMany) {
  SampleRun run({"grey"});
  EXPECT_TRUE(has(probes_text(run.result()), "axis")) << probes_text(run.result());
  run.probes.resize(100, run.probes.front());
  EXPECT_EQ(probes_text(run.result()), "\nprobes: 100 points, see probes.csv\n");
}

TEST(RunReport, CautionsOnlyWhereThereIsReason) {
  SampleRun run({"grey"});
  EXPECT_EQ(cautions_text(run.result()), "");
  run.solution.negative[0] = {3, -0.25};
  EXPECT_TRUE(has(cautions_text(run.result()), "3 of 24 values, smallest -0.25 W/m^2"));
}

TEST(RunReport, SaysHowToOpenTheFiles) {
  const std::string text = closing_text(SampleRun({"grey"}).result(), {"/r", {"fields.vtu", "walls.vtp"}, 1});
  EXPECT_TRUE(has(text, "paraview /r/fields.vtu /r/walls.vtp")) << text;
  EXPECT_TRUE(has(text, "read 0.5  mesh 1.5")) << text;
}

}  // namespace
}  // namespace etendue
