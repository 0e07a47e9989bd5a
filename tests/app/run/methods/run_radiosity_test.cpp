// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/app/run/empty_cube.h"
#include "tests/app/run/small_case.h"

namespace etendue::run_radiosity_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::empty_cube;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::text_of;

json summary_in(const std::filesystem::path& results) {
  return json::parse(text_of(results / "summary.json"));
}

TEST(RunRadiosity, WritesWhatOtherMethodsWriteWithItsChecks) {
  const CaseFolder folder(empty_cube());
  const Outcome outcome =
      etendue_says({"run", folder.file(), "--output", folder.results(), "--set", "radiosity.passes=2"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_EQ(
      ScratchFolder::names_in(folder.results()),
      (std::vector<std::string>{"fields.vtu", "form_factors.csv", "history.csv", "log.txt", "passes.csv",
                                "probes.csv", "regions.csv", "solution.vtu", "summary.json", "walls.csv",
                                "walls.vtp", "walls.vtp.series", "walls_pass1.vtp", "walls_pass2.vtp"}));
  EXPECT_TRUE(has(outcome.out, "A_j F_jk = A_k F_kj")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "patches: ")) << outcome.out;
  const json summary = summary_in(folder.results());
  EXPECT_EQ(summary["method"], "radiosity");
  EXPECT_TRUE(summary["converged"]);
  EXPECT_LT(summary["radiosity"]["row_sum_error_closed"].get<double>(), 1e-11);
  for (const json& balance : summary["balance"]) EXPECT_LT(std::abs(balance["residual"].get<double>()), 1e-7);
  const std::string factors = text_of(folder.path() / "results/form_factors.csv");
  double opposite = 0;
  ASSERT_EQ(std::sscanf(factors.c_str() + factors.find("floor,zmax,"), "floor,zmax,%lf", &opposite), 1);
  EXPECT_NEAR(opposite, 0.199824895698, 1e-6);
  const json series = json::parse(text_of(folder.path() / "results/walls.vtp.series"));
  EXPECT_EQ(series["files"][1]["name"], "walls_pass2.vtp");
}

// A probe on the floor that looks down sees the floor alone: B = pi L + rho E.
TEST(RunRadiosity, ProbesOnWallsSeeTheLightBeforeThem) {
  const CaseFolder folder(empty_cube());
  for (const char* solution : {"gathering", "shooting", "direct"}) {
    const Outcome outcome = etendue_says({"run", folder.file(), "--output", folder.results(), "--set",
                                          std::string("radiosity.solution=\"") + solution + "\"", "--set",
                                          "radiosity.patch_size=2"});
    ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
    const std::string probes = text_of(folder.path() / "results/probes.csv");
    const std::string walls = text_of(folder.path() / "results/walls.csv");
    double outgoing = 0, irradiance = 0;
    ASSERT_EQ(std::sscanf(walls.c_str() + walls.find("floor,red"), "floor,red,%*f,%*f,%*f,%lf", &outgoing),
              1);
    ASSERT_EQ(std::sscanf(probes.c_str() + probes.find("up,1,"), "up,1,%*f,%*f,%*f,red,%*f,%*f,%*f,%*f,%lf",
                          &irradiance),
              1);
    EXPECT_NEAR(irradiance, outgoing, 1e-5 * outgoing) << solution;
  }
}

TEST(RunRadiosity, RefusesWhatItDoesNotKnow) {
  const CaseFolder folder(empty_cube());
  const auto fault = [&](const std::string& assignment) {
    const Outcome outcome =
        etendue_says({"run", folder.file(), "--output", folder.results(), "--set", assignment});
    EXPECT_EQ(outcome.code, ExitCode::input_error);
    return outcome.err;
  };
  EXPECT_TRUE(has(fault("media.air.absorption=0.1"), "media.air.absorption: is not 0 (radiosity carries"));
  const std::string refracted = fault("walls.floor={radiance=1,refractive_index=1.5}");
  EXPECT_TRUE(has(refracted, "walls.floor.radiance: is refracted as it comes in")) << refracted;
  EXPECT_TRUE(
      has(fault("light=[{name=\"bulb\",kind=\"point\",position=[0.5,0.5,0.5],power=1}]"), "is a light"));
  EXPECT_TRUE(has(fault("output.fields=[\"radiance:0\"]"), "radiosity has none"));
  EXPECT_TRUE(has(fault("directions={set=\"flatland\",order=4}"), "flatland"));
}

// A sensor has the lamp's image in a mirror exactly and the rest from the patches, a probe all of it along
// rays.
TEST(RunRadiosity, SensorsAndProbesSeeTheSameByWayOfAMirror) {
  const CaseFolder folder(empty_cube());
  const Outcome outcome =
      etendue_says({"run", folder.file(), "--output", folder.results(), "--set", "radiosity.patch_size=0.2",
                    "--set", "walls.xmin={specular=0.8,diffuse=0.1}", "--set", "walls.floor.uncollided=true",
                    "--set", "walls.ymax={diffuse=0.2,glossy={model=\"phong\",exponent=20,reflectance=0.5}}",
                    "--set", "probe=[{name=\"p\",points=[[0.6,0.4,0.5]],normal=[-1,0,0]}]", "--set",
                    "sensor=[{name=\"s\",kind=\"irradiance\",position=[0.6,0.4,0.5],normal=[-1,0,0]}]"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "mirrors and glossy walls connect a patch with")) << outcome.out;
  const json summary = summary_in(folder.results());
  EXPECT_LT(summary["radiosity"]["extended"]["row_sum_error_closed"].get<double>(), 1e-11);
  for (const json& balance : summary["balance"]) EXPECT_LT(std::abs(balance["residual"].get<double>()), 1e-5);
  const std::string probes = text_of(folder.path() / "results/probes.csv");
  const std::string sensors = text_of(folder.path() / "results/sensors.csv");
  double at_probe = 0, uncollided = 0, at_sensor = 0;
  ASSERT_EQ(
      std::sscanf(probes.c_str() + probes.find("p,0,"), "p,0,%*f,%*f,%*f,red,%*f,%*f,%*f,%*f,%lf", &at_probe),
      1);
  ASSERT_EQ(std::sscanf(sensors.c_str() + sensors.find("s,red,irradiance"), "s,red,irradiance,%lf,%*f,%lf",
                        &uncollided, &at_sensor),
            2);
  EXPECT_GT(uncollided, 0.2 * at_sensor);
  EXPECT_NEAR(at_sensor, at_probe, 0.01 * at_probe);
  // What arrives is redirected or sent on by its walls, or stays.
  std::istringstream passes(text_of(folder.path() / "results/passes.csv"));
  std::string line;
  std::getline(passes, line);
  EXPECT_EQ(line, "pass,band,exitant,incident,redirected,deposit");
  std::getline(passes, line);
  double exitant, incident, redirected;
  ASSERT_EQ(std::sscanf(line.c_str(), "1,red,%lf,%lf,%lf", &exitant, &incident, &redirected), 3);
  EXPECT_GT(redirected, 0.1 * exitant);
  EXPECT_NEAR(incident - redirected, exitant, 1e-9 * exitant);
}

// A floor that is brightest beside the bright wall: the patches there are cut, and walls.vtp shows them.
TEST(RunRadiosity, CutsPatchesWhereTheLightChanges) {
  const CaseFolder folder(empty_cube());
  const Outcome outcome =
      etendue_says({"run", folder.file(), "--output", folder.results(), "--set", "radiosity.patch_size=0.6",
                    "--set", "radiosity.refine_change=0.3", "--set", "radiosity.smallest_patch=0.3", "--set",
                    "radiosity.passes=1"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "cut where the light changes, 1: patches: ")) << outcome.out;
  const json rounds = summary_in(folder.results())["radiosity"]["patches_by_round"];
  ASSERT_GT(rounds.size(), 1u);
  EXPECT_GT(rounds.back().get<int>(), rounds.front().get<int>());
  for (const char* name : {"walls.vtp", "walls_pass1.vtp"})
    EXPECT_TRUE(has(text_of(folder.path() / "results" / name), "Name=\"patch\"")) << name;
  const Outcome endless = etendue_says({"run", folder.file(), "--set", "radiosity.refine_change=0.3"});
  EXPECT_EQ(endless.code, ExitCode::input_error);
  EXPECT_TRUE(has(endless.err, "refine_change")) << endless.err;
  EXPECT_TRUE(has(endless.err, "give smallest_patch, or patch_size")) << endless.err;
}

// Links between groups of patches in place of the matrix: the same walls, to some ten times the tolerance of
// a link, and the power closes as well.
TEST(RunRadiosity, SolvesAlongLinksToo) {
  const CaseFolder folder(empty_cube());
  std::vector<double> means;
  for (const char* solution : {"gathering", "hierarchical"}) {
    const Outcome outcome =
        etendue_says({"run", folder.file(), "--output", folder.results(), "--set", "radiosity.patch_size=0.3",
                      "--set", std::string("radiosity.solution=\"") + solution + "\""});
    ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
    EXPECT_EQ(has(outcome.out, " links between groups of patches"), means.size() == 1) << outcome.out;
    const std::string walls = text_of(folder.path() / "results/walls.csv");
    double mean = 0;
    ASSERT_EQ(std::sscanf(walls.c_str() + walls.find("floor,red"), "floor,red,%*f,%lf", &mean), 1);
    means.push_back(mean);
  }
  const json summary = summary_in(folder.results());
  EXPECT_GT(summary["radiosity"]["links"].get<int>(), 0);
  EXPECT_NEAR(means[1], means[0], 3e-3 * means[0]);
  for (const json& balance : summary["balance"]) EXPECT_LT(std::abs(balance["residual"].get<double>()), 1e-7);
}

TEST(RunRadiosity, HasTheSameBitsForAnyNumberOfThreads) {
  const CaseFolder folder(empty_cube());
  for (const char* threads : {"1", "3"})
    ASSERT_EQ(etendue_says({"run", folder.file(), "--output", (folder.path() / threads).string(), "--threads",
                            threads})
                  .code,
              ExitCode::done);
  for (const char* name : {"fields.vtu", "walls.vtp", "walls.csv", "passes.csv", "probes.csv"})
    EXPECT_EQ(text_of(folder.path() / "1" / name), text_of(folder.path() / "3" / name)) << name;
}

// Three methods that share nothing but the problem.
TEST(RunRadiosity, AgreesWithOrdinatesAndPhotons) {
  const CaseFolder folder(empty_cube());
  const Outcome outcome = etendue_says({"compare", folder.file(), "--output", folder.results(), "--methods",
                                        "radiosity,ordinates,photons", "--set", "solve.photons=20000",
                                        "--set", "solve.probe_photons=2000", "--set", "directions.order=2"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  for (const char* name :
       {"comparison-ordinates.csv", "comparison-photons.csv", "comparison-photons.html",
        "difference-ordinates.vtu", "ordinates", "photons", "radiosity", "radiosity-patches"})
    EXPECT_EQ(std::ranges::count(ScratchFolder::names_in(folder.results()), name), 1) << name;
  const std::string table = text_of(folder.path() / "results/comparison-photons.csv");
  double in_errors = 100;
  ASSERT_EQ(std::sscanf(table.c_str() + table.find("\"region air\",\"red\",fluence"),
                        "\"region air\",\"red\",fluence,%*f,%*f,%*f,%*f,%*f,%lf", &in_errors),
            1)
      << table;
  EXPECT_LT(std::abs(in_errors), 3) << table;
}

}  // namespace
}  // namespace etendue::run_radiosity_test
