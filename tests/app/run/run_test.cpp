// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"
#include "tests/support/checkout.h"

namespace etendue::run_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::text_of;

const std::vector<std::string> all_files = {"fields.vtu",   "history.csv", "log.txt",
                                            "probes.csv",   "regions.csv", "solution.vtu",
                                            "summary.json", "walls.csv",   "walls.vtp"};

json summary_in(const std::filesystem::path& results) {
  return json::parse(text_of(results / "summary.json"));
}

TEST(Run, WritesAllFilesAndSaysWhere) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(ScratchFolder::names_in(folder.results()), all_files);
  EXPECT_TRUE(has(outcome.out, "paraview " + folder.results() + "/fields.vtu")) << outcome.out;
}

TEST(Run, ClosesTheBalanceOfEachBand) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says({"run", folder.file(), "--set", "solve.tolerance=1e-12"}).code, ExitCode::done);
  const json summary = summary_in(folder.results());
  ASSERT_EQ(summary["balance"].size(), 3U);
  for (const json& balance : summary["balance"]) {
    EXPECT_GT(balance["inflow"], 0.1);
    EXPECT_LT(std::abs(balance["residual"].get<double>()), 1e-10);
  }
}

TEST(Run, SendsRaysThroughTheFlatCellsOfADuct) {
  // A ray along the planes of this duct met edges whose signs contradicted each other by rounding.
  const ScratchFolder folder;
  const std::string file = test::checkout("cases/kobayashi-3/uncollided-ii.toml");
  const Outcome outcome =
      etendue_says({"run", file, "--output", (folder.path() / "duct").string(), "--set", "directions.order=1",
                    "--set", R"(mesh.max_volume={ "*" = 4000, source = 40 })"});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
}

TEST(Run, TakesTheMeanOfRotatedSets) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says(
      {"run", folder.file(), "--set", "directions.rotations=3", "--set", "solve.tolerance=1e-9"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, ", 3 rotations")) << outcome.out;
  const json summary = summary_in(folder.results());
  EXPECT_TRUE(has(summary["notes"].dump(), "mean of 3 rotated sets of directions; the standard error"));
  for (const json& balance : summary["balance"]) EXPECT_LT(std::abs(balance["residual"].get<double>()), 1e-7);
}

TEST(Run, SweepsLightThatCollidedOnceOnASetOfItsOwn) {
  const ScratchFolder folder;
  const std::string file = test::checkout("cases/kobayashi-1/uncollided-ii.toml");
  const auto run = [&](const std::string& first_collided) {
    std::vector<std::string> words = {"run",      file,
                                      "--output", (folder.path() / "ladder").string(),
                                      "--set",    "directions.order=1",
                                      "--set",    R"(mesh.max_volume={ "*" = 8000, source = 200 })",
                                      "--set",    "probe=[]"};
    if (!first_collided.empty()) words.insert(words.end(), {"--set", first_collided});
    return etendue_says(words);
  };
  const Outcome outcome = run("directions.first_collided={ order = 2 }");
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out,
                  "directions: 96 (ldfe-sq 1), once 384 (ldfe-sq 2) for light that has collided "
                  "once"))
      << outcome.out;
  const json ladder = summary_in(folder.path() / "ladder");
  EXPECT_TRUE(has(ladder["notes"].dump(), "light that collided once: 1 sweep of 384 directions"));
  EXPECT_LT(std::abs(ladder["balance"][0]["residual"].get<double>() -
                     ladder["uncollided"][0]["residual"].get<double>()),
            1e-6);
}

TEST(Run, RefusesASetForLightThatCollidedOnceWithoutLights) {
  const CaseFolder folder;
  const Outcome outcome =
      etendue_says({"run", folder.file(), "--set", "directions.first_collided={ order = 2 }"});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "nothing of this case is a light")) << outcome.err;
}

TEST(Run, HasTheSameBitsForAnyNumberOfThreads) {
  const CaseFolder folder;
  const auto results_with = [&](int threads) {
    return folder.path() / ("threads-" + std::to_string(threads));
  };
  for (const int threads : {1, 2, 3, 4})
    ASSERT_EQ(etendue_says({"run", folder.file(), "--threads", std::to_string(threads), "--output",
                            results_with(threads).string()})
                  .code,
              ExitCode::done);
  for (const int threads : {2, 3, 4})
    for (const std::string& name : all_files)
      if (name != "summary.json" && name != "log.txt") {
        EXPECT_EQ(text_of(results_with(1) / name), text_of(results_with(threads) / name)) << name << threads;
      }
  EXPECT_EQ(summary_in(results_with(3))["threads"], 3);
}

TEST(Run, ThatDoesNotConvergeWritesItsResultsMarked) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "solve.max_sweeps=2"});
  EXPECT_EQ(outcome.code, ExitCode::not_converged);
  EXPECT_TRUE(has(outcome.err, "not converged")) << outcome.err;
  EXPECT_EQ(summary_in(folder.results())["converged"], false);
  EXPECT_EQ(ScratchFolder::names_in(folder.results()), all_files);
}

std::string initial_in(const CaseFolder& folder) {
  return "solve.initial='" + folder.results() + "/solution.vtu'";
}

/// The fluence at the probe, [band].
std::vector<double> probed(const CaseFolder& folder) {
  return CsvTable(text_of(std::filesystem::path(folder.results()) / "probes.csv")).numbers("fluence");
}

TEST(Run, GoesOnFromItsSolutionToTheSameAnswer) {
  const CaseFolder folder;
  const std::vector<std::string> tight = {"run", folder.file(), "--set", "solve.tolerance=1e-9"};
  ASSERT_EQ(etendue_says(tight).code, ExitCode::done);
  const std::vector<double> expected = probed(folder);
  std::vector<std::string> arguments = tight;
  arguments.insert(arguments.end(), {"--set", "solve.max_sweeps=4"});
  const Outcome stopped = etendue_says(arguments);
  ASSERT_EQ(stopped.code, ExitCode::not_converged);
  EXPECT_TRUE(has(stopped.err, "--set 'solve.initial=\"" + folder.results() + "/solution.vtu\"'"))
      << stopped.err;
  arguments = tight;
  arguments.insert(arguments.end(), {"--set", initial_in(folder)});
  ASSERT_EQ(etendue_says(arguments).code, ExitCode::done);
  const std::vector<double> continued = probed(folder);
  ASSERT_EQ(continued.size(), 3U);
  for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(continued[b], expected[b], 1e-8 * expected[b]);
}

TEST(Run, KeepsValuesPositiveAndSaysWhatThatMoved) {
  const CaseFolder folder;
  std::vector<std::string> arguments = {"run", folder.file(), "--set", "media.smoke.absorption=60"};
  ASSERT_EQ(etendue_says(arguments).code, ExitCode::done);
  EXPECT_GT(summary_in(folder.results())["negative"][0]["count"], 0);
  EXPECT_FALSE(summary_in(folder.results()).contains("positivity"));
  arguments.insert(arguments.end(), {"--set", "space.positivity='quadratic'"});
  const Outcome outcome = etendue_says(arguments);
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "kept positive in band red: ")) << outcome.out;
  const json summary = summary_in(folder.results());
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_EQ(summary["negative"][b]["count"], 0);
    EXPECT_GT(summary["positivity"][b]["cells"], 0);
    EXPECT_EQ(summary["positivity"][b]["failed"], 0);
    EXPECT_LT(summary["positivity"][b]["smallest"], 0);
    EXPECT_GT(summary["positivity"][b]["moved"], 0);
  }
  const std::string table = text_of(std::filesystem::path(folder.results()) / "positivity.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 8 * 3);
}

TEST(Run, DoesNotGoOnFromAnotherCaseAndSaysSoBeforeItMeshes) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const Outcome outcome =
      etendue_says({"run", folder.file(), "--set", initial_in(folder), "--set", "media.smoke.scattering=2",
                    "--output", (folder.path() / "other").string()});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "is a solution of another case ([media] differ)")) << outcome.err;
  EXPECT_FALSE(has(outcome.out, "cells")) << outcome.out;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "other"));
}

TEST(Run, RefusesAnOutputDirectoryThatIsAFileBeforeItMeshes) {
  const CaseFolder folder;
  test::write_text(folder.results(), "mine");
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::file_error);
  EXPECT_TRUE(has(outcome.err, folder.results())) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(text_of(folder.results()), "mine");
}

TEST(Run, RefusesAProbeOutsideTheMeshBeforeItSolves) {
  const CaseFolder folder(test::small_case() + "[[probe]]\nname = \"out\"\npoints = [[2, 0, 0]]\n");
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "case.toml:")) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "probe \"out\" lies outside")) << outcome.err;
  EXPECT_EQ(ScratchFolder::names_in(folder.path()), std::vector<std::string>{"case.toml"});
}

TEST(Run, RefusesAnOrdinateThatTheSetDoesNotHave) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "output.fields=['radiance:8']"});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "\"radiance:8\"")) << outcome.err;
}

TEST(Run, MeasuresTheIrradianceOfAProbeWithANormal) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const std::string table = text_of(std::filesystem::path(folder.results()) / "probes.csv");
  const std::string row = table.substr(table.find("\nmiddle,0,0.5,0.5,0.5,red,") + 1);
  const double irradiance = std::stod(row.substr(row.substr(0, row.find('\n')).rfind(',') + 1));
  EXPECT_GT(irradiance, 0);  // the walls above reflect
  EXPECT_LT(irradiance, 1);  // and less than the floor emits
}

}  // namespace
}  // namespace etendue::run_test
