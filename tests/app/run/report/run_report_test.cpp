// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/run_report.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/write/sample_run.h"

namespace etendue::run_report_test {
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

TEST(RunReport, NamesTheUnitOfEachColumn) {
  const SampleRun run({"grey"});
  const RunResult result = run.result();
  EXPECT_TRUE(has(powers_text(result), "area [m^2]")) << powers_text(result);
  EXPECT_TRUE(has(powers_text(result), "irradiance [W/m^2]"));
  EXPECT_TRUE(has(powers_text(result), "incoming [W]"));
  EXPECT_TRUE(has(powers_text(result), "volume [m^3]"));
  EXPECT_TRUE(has(probes_text(result), "net flux [W/m^2]")) << probes_text(result);
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
  // Vertex 0 of the last cell; all 24 values stand for a quarter of a cell of 1/6 each, the others are 1.
  std::fill(run.solution.fluence.begin(), run.solution.fluence.end(), 1);
  run.solution.fluence[20] = -0.25;
  const std::string text = cautions_text(run.result());
  const Vec3& place = run.mesh.point(VertexIndex(run.mesh.vertices(CellIndex(5))[0]));
  EXPECT_TRUE(has(text, "1 of 24 values, together 1.1 % of all fluence; smallest -0.25 W/m^2")) << text;
  EXPECT_TRUE(has(text, fmt::format("at ({:.4g}, {:.4g}, {:.4g})", place.x(), place.y(), place.z()))) << text;
  EXPECT_TRUE(has(text, "WARNING: that is much")) << text;
  EXPECT_TRUE(has(text, "space.positivity = \"rescale\"")) << text;
  EXPECT_TRUE(has(text, "docs/user/positivity.md")) << text;
}

TEST(RunReport, SaysThatALittleNegativeFluenceDoesNotMatter) {
  SampleRun run({"grey"});
  std::fill(run.solution.fluence.begin(), run.solution.fluence.end(), 1);
  run.solution.fluence[20] = -0.01;
  const std::string text = cautions_text(run.result());
  EXPECT_TRUE(has(text, "together 0.043 % of all fluence")) << text;
  EXPECT_TRUE(has(text, "powers and means do not suffer")) << text;
  EXPECT_FALSE(has(text, "WARNING")) << text;
}

TEST(RunReport, CautionsWhereTheBalanceIsOffByLessThanItsTolerance) {
  const SampleRun run({"red", "green"});
  RunResult result = run.result();
  result.balances[1].residual = -4e-3;
  const std::string text = balance_text(result);
  EXPECT_TRUE(
      has(text, "warning: -0.4 % in band green of the power is lost (negative: gained), more than 0.3 %"))
      << text;
  EXPECT_FALSE(has(text, "NOT BALANCED")) << text;
  result.balances[1].residual = 2.9e-3;
  EXPECT_FALSE(has(balance_text(result), "warning"));
  result.balances[1].residual = 0.02;
  EXPECT_TRUE(has(balance_text(result), "NOT BALANCED"));
  EXPECT_FALSE(has(balance_text(result), "warning: "));
}

TEST(RunReport, SaysHowToOpenTheFiles) {
  const std::string text = closing_text(SampleRun({"grey"}).result(), {"/r", {"fields.vtu", "walls.vtp"}, 1});
  EXPECT_TRUE(has(text, "written to /r: fields.vtu walls.vtp log.txt\n")) << text;
  EXPECT_TRUE(has(text, "paraview /r/fields.vtu /r/walls.vtp")) << text;
  EXPECT_TRUE(has(text, "read 0.5  mesh 1.5")) << text;
}

}  // namespace
}  // namespace etendue::run_report_test
