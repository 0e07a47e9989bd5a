// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Runs and studies of cases with [exact], whose solution is known.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/run/small_case.h"
#include "tests/app/study/exact_case.h"
#include "tests/support/checkout.h"

namespace etendue::exact_run_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::etendue_says;
using test::exact_case;
using test::has;
using test::Outcome;
using test::rows_of;
using test::study_of;
using test::text_of;

TEST(ExactRun, WritesItsErrorsAndClosesItsBalance) {
  const CaseFolder folder(exact_case());
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "against the exact solution")) << outcome.out;
  const json summary = json::parse(text_of(folder.path() / "results/summary.json"));
  EXPECT_GT(summary["exact"][0]["fluence_L2"], 1e-5);
  EXPECT_LT(summary["exact"][0]["fluence_L2"], summary["exact"][0]["fluence_Linf"]);
  EXPECT_GT(summary["balance"][0]["inflow"], 1);
  EXPECT_LT(std::abs(summary["balance"][0]["residual"].get<double>()), 1e-6);
}

TEST(ExactRun, RefusesOtherSourcesAndMirrors) {
  const auto error_with = [](const std::string& change) {
    const CaseFolder folder(exact_case());
    const Outcome outcome = etendue_says({"run", folder.file(), "--set", change});
    EXPECT_EQ(outcome.code, ExitCode::input_error);
    return outcome.err;
  };
  EXPECT_TRUE(has(error_with("media.medium.emission=1"), "emits in a case with [exact]"));
  EXPECT_TRUE(has(error_with("walls.'*'.radiance=1"), "emits in a case with [exact]"));
  EXPECT_TRUE(has(error_with("walls.'*'.diffuse=0.5"), "reflects in a case with [exact]"));
  EXPECT_TRUE(has(error_with("exact.radiance='sin('"), "exact.radiance"));
  EXPECT_TRUE(has(error_with("exact.radiance='1/x'"), "is not finite"));
}

TEST(ExactRun, RefusesCamerasAndSensors) {
  const auto error_beside = [](const std::string& table) {
    const CaseFolder folder(exact_case() + table);
    const Outcome outcome = etendue_says({"run", folder.file()});
    EXPECT_EQ(outcome.code, ExitCode::input_error);
    return outcome.err;
  };
  EXPECT_TRUE(
      has(error_beside("\n[[sensor]]\nname = \"meter\"\nposition = [0.5, 0.5, 0.5]\nnormal = [0, 0, 1]\n"),
          "a sensor in a case with [exact]"));
  EXPECT_TRUE(has(
      error_beside("\n[[camera]]\nname = \"front\"\nposition = [0.1, 0.5, 0.5]\nlook_at = [1, 0.5, 0.5]\n"),
      "a camera in a case with [exact]"));
}

/// A study of a case in this repository on three meshes that TetGen makes anew.
json study_of_case(const std::string& name, const std::vector<std::string>& changes) {
  const test::ScratchFolder folder;
  std::vector<std::string> arguments = study_of(test::checkout("cases/" + name + "/case.toml"), "mesh", 3);
  arguments.insert(arguments.end(), {"--output", folder.path().string()});
  for (const std::string& change : changes) arguments.insert(arguments.end(), {"--set", change});
  const Outcome outcome = etendue_says(arguments);
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  return json::parse(text_of(folder.path() / "study.json"));
}

double last_order(const json& study, const std::string& quantity) {
  const json row = rows_of(study, quantity).back();
  EXPECT_LT(row["iteration"], 0.1 * row["error"].get<double>()) << quantity;
  return row["order"];
}

TEST(SmoothCase, IsOfSecondOrderWithLinearElementsAndOfThirdInItsTotals) {
  const json study = study_of_case("mms-smooth", {});
  EXPECT_GE(last_order(study, "fluence_L2"), 1.95);
  EXPECT_GE(last_order(study, "fluence_mean_L2"), 1.95);
  EXPECT_GE(last_order(study, "region:medium:absorbed"), 2.95);
  EXPECT_GE(last_order(study, "wall:xmin:incoming"), 2.95);
}

TEST(SmoothCase, IsOfFirstOrderWithConstants) {
  EXPECT_GE(last_order(study_of_case("mms-smooth", {"space.order=0"}), "fluence_L2"), 0.9);
}

TEST(LinearCase, IsReproducedToRounding) {
  const test::ScratchFolder folder;
  const Outcome outcome =
      etendue_says({"run", test::checkout("cases/mms-linear/case.toml"), "--output", folder.path().string()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  const json summary = json::parse(text_of(folder.path() / "summary.json"));
  EXPECT_LT(summary["exact"][0]["fluence_L2"], 1e-11);
  EXPECT_LT(summary["exact"][0]["fluence_Linf"], 1e-11);
}

}  // namespace
}  // namespace etendue::exact_run_test
