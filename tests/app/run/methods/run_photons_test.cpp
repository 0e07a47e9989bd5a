// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::run_photons_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::small_case;
using test::text_of;

std::vector<std::string> by_photons(const CaseFolder& folder, const std::string& results,
                                    const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"run",      folder.file(),
                                        "--set",    "solve.method=\"photons\"",
                                        "--set",    "solve.photons=3000",
                                        "--set",    "solve.probe_photons=500",
                                        "--output", results};
  for (const std::string& argument : more) arguments.push_back(argument);
  return arguments;
}

json summary_in(const std::filesystem::path& results) {
  return json::parse(text_of(results / "summary.json"));
}

TEST(RunPhotons, WritesWhatOtherMethodsWriteWithErrors) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says(by_photons(folder, folder.results()));
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_EQ(ScratchFolder::names_in(folder.results()),
            (std::vector<std::string>{"fields.vtu", "history.csv", "log.txt", "probes.csv", "regions.csv",
                                      "solution.vtu", "summary.json", "walls.csv", "walls.vtp"}));
  EXPECT_TRUE(has(outcome.out, "figure of merit")) << outcome.out;
  EXPECT_TRUE(has(text_of(folder.path() / "results/walls.csv"), "incoming_error"));
  EXPECT_TRUE(has(text_of(folder.path() / "results/regions.csv"), "absorbed_error"));
  EXPECT_TRUE(has(text_of(folder.path() / "results/probes.csv"), "irradiance_error"));
  EXPECT_TRUE(has(text_of(folder.path() / "results/fields.vtu"), "Name=\"fluence_error\""));
  const json summary = summary_in(folder.results());
  EXPECT_EQ(summary["method"], "photons");
  EXPECT_EQ(summary["photons"]["histories"], 3000);
  for (const json& balance : summary["balance"]) EXPECT_LT(std::abs(balance["residual"].get<double>()), 1e-2);
}

const std::vector<std::string> without_light_inside = {"--set", "media.smoke.absorption=1e6", "--set",
                                                       "media.smoke.scattering=0"};

// In matter of a million free paths no history comes from the floor to the middle: of 500 that are walked
// back fewer than three would, each with 4 pi times the floor's radiance at most.
TEST(RunPhotons, ProbesThatNoHistoryReachesHaveAnUpperBoundAsError) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says(by_photons(folder, folder.results(), without_light_inside));
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "values of probes that no history reached: 3;")) << outcome.out;
  const CsvTable table(text_of(folder.path() / "results/probes.csv"));
  EXPECT_EQ(table.numbers("fluence"), std::vector<double>(3, 0));
  const std::vector<double> errors = table.numbers("fluence_error");
  for (std::size_t b = 0; b < 3; ++b)
    EXPECT_NEAR(errors[b], 3 * 4 * std::numbers::pi * (1 - 0.2 * static_cast<double>(b)) / 500, 1e-9);
  for (const double error : CsvTable(text_of(folder.path() / "results/walls.csv")).numbers("incoming_error"))
    EXPECT_GT(error, 0);
}

TEST(RunPhotons, ComparisonCountsUnreachedProbesInFiniteErrors) {
  const CaseFolder folder;
  std::vector<std::string> arguments = {
      "compare", folder.file(),        "--methods", "ordinates,photons",
      "--set",   "solve.photons=1000", "--set",     "solve.probe_photons=500"};
  arguments.insert(arguments.end(), without_light_inside.begin(), without_light_inside.end());
  const Outcome outcome = etendue_says(arguments);
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "photons: values of probes that no history reached: 3;")) << outcome.out;
  const CsvTable comparison(text_of(folder.path() / "results/comparison.csv"));
  int probes = 0;
  for (const std::vector<std::string>& row : comparison.rows()) {
    if (!row.front().starts_with("\"probe")) continue;
    ++probes;
    EXPECT_LT(std::abs(std::stod(row.back())), 3) << row.front();
  }
  EXPECT_EQ(probes, 6);  // fluence and irradiance in three bands
}

// Three standard errors of the residual are allowed beside the tolerance.
TEST(RunPhotons, StatisticalErrorIsNoLossOfLight) {
  const CaseFolder folder;
  const Outcome outcome =
      etendue_says(by_photons(folder, folder.results(), {"--set", "solve.balance_tolerance=1e-30"}));
  const json summary = summary_in(folder.results());
  for (std::size_t b = 0; b < 3; ++b) {
    const double residual = std::abs(summary["balance"][b]["residual"].get<double>());
    EXPECT_GT(residual, 1e-30);
    EXPECT_LT(residual, 3 * summary["photons"]["balance_error"][b]["residual"].get<double>());
  }
  EXPECT_EQ(summary["balanced"], true);
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
}

TEST(RunPhotons, HasTheSameBitsForAnyNumberOfThreads) {
  const CaseFolder folder;
  for (const char* threads : {"1", "3"})
    ASSERT_EQ(
        etendue_says(by_photons(folder, (folder.path() / threads).string(), {"--threads", threads})).code,
        ExitCode::done);
  for (const char* name : {"fields.vtu", "walls.vtp", "walls.csv", "regions.csv", "probes.csv"})
    EXPECT_EQ(text_of(folder.path() / "1" / name), text_of(folder.path() / "3" / name)) << name;
}

TEST(RunPhotons, AddsToAnEarlierRun) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says(by_photons(folder, folder.results())).code, ExitCode::done);
  const std::string initial = "solve.initial=\"" + folder.results() + "/solution.vtu\"";
  const Outcome outcome =
      etendue_says(by_photons(folder, (folder.path() / "more").string(), {"--set", initial}));
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_EQ(summary_in(folder.path() / "more")["photons"]["histories"], 6000);
}

TEST(RunPhotons, SaysThatTheErrorIsStillTooLarge) {
  const CaseFolder folder;
  const Outcome outcome = etendue_says(by_photons(folder, folder.results(), {"--set", "solve.until=1e-4"}));
  EXPECT_EQ(outcome.code, ExitCode::not_converged);
  EXPECT_TRUE(has(outcome.err, "the error is above solve.until = 0.0001 after solve.photons = 3000"))
      << outcome.err;
}

TEST(RunPhotons, StartsFromPhotonsOnly) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says({"run", folder.file()}).code, ExitCode::done);
  const std::string initial = "solve.initial=\"" + folder.results() + "/solution.vtu\"";
  const Outcome outcome =
      etendue_says(by_photons(folder, (folder.path() / "more").string(), {"--set", initial}));
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "is not a solution by photons")) << outcome.err;
}

TEST(RunPhotons, GivesNothingForSweepsToStartFrom) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says(by_photons(folder, folder.results())).code, ExitCode::done);
  const Outcome outcome = etendue_says({"run", folder.file(), "--output", (folder.path() / "more").string(),
                                        "--set", "solve.initial=\"" + folder.results() + "/solution.vtu\""});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "is a solution by photons, and sweeps cannot go on from it")) << outcome.err;
}

const std::string camera = R"(
[[camera]]
name = "front"
position = [0.5, -1.5, 0.5]
look_at = [0.5, 0.5, 0.5]
pixels = [12, 8]
)";

TEST(RunPhotons, TakesPicturesFromItsMapAndRenderTakesThemAgain) {
  const CaseFolder folder(small_case() + camera);
  const Outcome run = etendue_says(by_photons(folder, folder.results(), {"--set", "photon_map.hits=20000"}));
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  EXPECT_TRUE(has(run.out, "photon map: ")) << run.out;
  EXPECT_TRUE(has(run.out, "picture front: 12 x 8 pixels, 1 ray each")) << run.out;
  EXPECT_FALSE(has(run.out, "is black")) << run.out;
  const std::filesystem::path results = folder.results();
  const std::string exr = text_of(results / "front.exr");
  std::filesystem::remove(results / "front.exr");
  for (const char* threads : {"1", "3"}) {
    const Outcome render = etendue_says({"render", folder.results(), "--threads", threads});
    ASSERT_EQ(render.code, ExitCode::done) << render.err;
    EXPECT_EQ(text_of(results / "front.exr"), exr) << threads;
  }
}

TEST(RunPhotons, RefusesErrorsOfPictures) {
  const CaseFolder folder(small_case() + camera + "errors = true\n");
  const Outcome outcome = etendue_says(by_photons(folder, folder.results()));
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "photon_map.neighbours")) << outcome.err;
}

/// The small case with leaves in place of smoke.
std::string leaves_case() {
  std::string text = small_case();
  const std::string smoke = "[media.smoke]\nabsorption = [0.1, 0.2, 0.3]\nscattering = 1.0\n";
  return text.replace(text.find(smoke), smoke.size(),
                      "[media.smoke.leaves]\narea_density = \"2 + x\"\nangles = \"planophile\"\n"
                      "reflectance = [0.1, 0.2, 0.4]\ntransmittance = 0.1\n");
}

TEST(RunPhotons, WalksThroughLeavesAndGoesOnFromThere) {
  const CaseFolder folder(leaves_case());
  ASSERT_EQ(etendue_says(by_photons(folder, folder.results())).code, ExitCode::done);
  const std::string first = folder.results();
  const Outcome more = etendue_says(by_photons(folder, (folder.path() / "more").string(),
                                               {"--set", "solve.initial=\"" + first + "/solution.vtu\""}));
  ASSERT_EQ(more.code, ExitCode::done) << more.err;
  const json summary = summary_in(folder.path() / "more");
  EXPECT_EQ(summary["photons"]["histories"], 6000);
  for (const json& balance : summary["balance"]) {
    EXPECT_GT(balance["absorbed"].get<double>(), 0);
    EXPECT_LT(std::abs(balance["residual"].get<double>()), 1e-2);
  }
}

TEST(RunPhotons, RefusesCamerasThatLookAtLeaves) {
  const CaseFolder folder(leaves_case() + camera);
  const Outcome outcome = etendue_says(by_photons(folder, folder.results()));
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "the photon map does not know that")) << outcome.err;
}

TEST(RunPhotons, RefusesTheRadianceOfAnOrdinate) {
  const CaseFolder folder;
  const Outcome outcome =
      etendue_says(by_photons(folder, folder.results(), {"--set", "output.fields=[\"radiance:1\"]"}));
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "asks for the radiance of an ordinate, and photons have none")) << outcome.err;
}

}  // namespace
}  // namespace etendue::run_photons_test
