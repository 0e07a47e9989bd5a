// SPDX-License-Identifier: AGPL-3.0-or-later
//
// `etendue run --estimate`: errors that it states beside those that are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "tests/app/run/small_case.h"

namespace etendue::estimate_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::text_of;

json summary_of(const CaseFolder& folder) {
  return json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
}

json number_of(const json& estimate, const std::string& where, const std::string& quantity) {
  for (const json& number : estimate["numbers"])
    if (number["where"] == where && number["quantity"] == quantity) return number;
  return {};
}

/// A cube of side 1 of hot gases between cold black walls, a band for each absorption coefficient.
constexpr const char* hot_gases = R"([bands]
names = ["0.1", "1", "2", "5", "10"]
[mesh]
max_volume = 5e-4
[[mesh.box]]
region = "gas"
min = [0, 0, 0]
max = [1, 1, 1]
[media.gas]
absorption = [0.1, 1, 2, 5, 10]
power_density = [0.4, 4, 8, 20, 40]
[walls."*"]
[directions]
order = 3
[[sensor]]
kind = "irradiance"
name = "meter"
position = [0.5, 0.5, 0.001]
normal = [0, 0, 1]
[output]
directory = "results"
)";

// Power on a wall, by exact integration along rays: validation/reference/cube_hot_medium_wall_flux.csv.
// Single errors change sign from wall to wall and are small by chance, so the median counts.
TEST(Estimate, IsWithinAFactorThreeOfTheTrueErrorOfAHotCube) {
  const std::map<std::string, double> exact = {
      {"0.1", 0.063775}, {"1", 0.446027}, {"2", 0.6467595}, {"5", 0.8423288}, {"10", 0.9182967}};
  const CaseFolder folder(hot_gases);
  const Outcome outcome = etendue_says({"run", folder.file(), "--estimate"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  const json estimate = summary_of(folder)["estimate"];
  std::vector<double> stated_over_true;
  for (const json& number : estimate["numbers"])
    if (number["where"].get<std::string>().starts_with("wall "))
      stated_over_true.push_back(number["error"].get<double>() /
                                 std::abs(number["value"].get<double>() - exact.at(number["band"])));
  ASSERT_EQ(stated_over_true.size(), 30U);
  std::ranges::nth_element(stated_over_true, stated_over_true.begin() + 15);
  EXPECT_GT(stated_over_true[15], 1. / 3) << outcome.out;
  EXPECT_LT(stated_over_true[15], 3) << outcome.out;
  EXPECT_FALSE(number_of(estimate, "sensor meter", "irradiance").is_null()) << estimate;
}

TEST(Estimate, LeavesTheResultsOfTheRunAndItsOwn) {
  const CaseFolder folder;
  std::ostringstream out, err;
  // Cheap enough to be done unasked.
  ASSERT_EQ(run_command({"run", folder.file()}, out, err), ExitCode::done) << err.str();
  const Outcome outcome{ExitCode::done, out.str(), err.str()};
  EXPECT_TRUE(has(outcome.out, "how far to trust the numbers")) << outcome.out;
  EXPECT_EQ(
      ScratchFolder::names_in(folder.results()),
      (std::vector<std::string>{"estimate.csv", "fields.vtu", "history.csv", "log.txt", "probes.csv",
                                "regions.csv", "solution.vtu", "summary.json", "walls.csv", "walls.vtp"}));
  const json summary = summary_of(folder);
  for (const char* where : {"region smoke", "wall floor", "probe middle 0"})
    EXPECT_TRUE(has(summary["estimate"]["numbers"].dump(), where)) << where;
  EXPECT_TRUE(has(outcome.out, summary["estimate"]["verdict"].get<std::string>())) << outcome.out;
  EXPECT_TRUE(text_of(std::filesystem::path(folder.results()) / "log.txt")
                  .ends_with(outcome.out.substr(outcome.out.find("\nhow far to trust the numbers"))));
  EXPECT_GT(summary["seconds"]["estimate"], 0);
  EXPECT_EQ(std::ranges::count(summary["files"], json("estimate.csv")), 1);
  // The next run has none, and removes it.
  const Outcome without = etendue_says({"run", folder.file(), "--no-estimate"});
  EXPECT_FALSE(has(without.out, "how far to trust")) << without.out;
  EXPECT_FALSE(summary_of(folder).contains("estimate"));
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(folder.results()) / "estimate.csv"));
}

TEST(Estimate, IsWantedOrNot) {
  const CaseFolder folder;
  const Outcome both = etendue_says({"run", folder.file(), "--estimate", "--no-estimate"});
  EXPECT_EQ(both.code, ExitCode::input_error);
  EXPECT_TRUE(has(both.err, "--no-estimate")) << both.err;
}

TEST(Estimate, SaysWhyTheErrorOfTheCellsIsNotKnown) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says({"mesh", folder.file(), "-o", (folder.path() / "mesh.vtu").string()}).code,
            ExitCode::done);
  test::write_text(
      folder.file(),
      "[mesh]\nfile = \"mesh.vtu\"\n[media.smoke]\nabsorption = 1\n[walls.floor]\nradiance = 1\n"
      "[walls.'*']\n[directions]\nset = \"product\"\norder = 2\n[output]\ndirectory = \"results\"\n");
  const Outcome outcome = etendue_says({"run", folder.file(), "--estimate"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "The error of the cells is not in this")) << outcome.out;
  EXPECT_EQ(summary_of(folder)["estimate"]["lower_bound"], true);
}

TEST(Estimate, OfPhotonsAndRadiosityIsTheirOwn) {
  const CaseFolder folder;
  const Outcome photons = etendue_says({"run", folder.file(), "--estimate", "--set", "solve.method='photons'",
                                        "--set", "solve.photons=20000"});
  ASSERT_TRUE(summary_of(folder).contains("estimate")) << photons.out << photons.err;
  EXPECT_EQ(summary_of(folder)["estimate"]["parts"][0]["cause"], "histories");
  const CaseFolder room(
      "[mesh]\nmax_volume = 0.1\n[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
      "walls = { zmin = \"floor\" }\n[media.air]\n[walls.floor]\nradiance = 1\n[walls.'*']\ndiffuse = 0.5\n"
      "[solve]\nmethod = \"radiosity\"\n[output]\ndirectory = \"results\"\n");
  const Outcome radiosity = etendue_says({"run", room.file(), "--estimate"});
  ASSERT_EQ(radiosity.code, ExitCode::done) << radiosity.err;
  EXPECT_EQ(summary_of(room)["estimate"]["parts"][0]["cause"], "patches");
}

/// An evenly lit room with a lamp, a desk under it and an observer.
constexpr const char* office = R"([bands]
names = ["light"]
edges = [400, 700]
[mesh]
edge_length = 0.6
[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [3, 3, 2.5]
[[mesh.patch]]
wall = "window"
min = [0, 1, 1]
max = [0, 2, 2]
[media.air]
[walls.window]
glazing = { transmittance = 0.8 }
[walls."*"]
diffuse = 0.5
[[light]]
name = "sky"
kind = "sky"
cie_type = 1
illuminance = 10000
walls = ["window"]
[[sensor]]
name = "desk"
kind = "grid"
position = [0.5, 0.5, 0.8]
along = [2, 0, 0]
across = [0, 2, 0]
normal = [0, 0, 1]
parts = [2, 2]
daylight_factor = true
[[sensor]]
name = "eye"
kind = "glare"
position = [2.5, 1.5, 1.2]
direction = [-1, 0, 0]
parts = [20]
[directions]
set = "product"
order = 2
[output]
directory = "results"
)";

// A ratio errs less than its parts where both err alike: the error is that of the ratio itself.
TEST(Estimate, TellsPhotometryAndRatiosOfSensors) {
  const CaseFolder folder(office);
  const Outcome outcome = etendue_says({"run", folder.file(), "--estimate"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  const json estimate = summary_of(folder)["estimate"];
  for (const char* quantity :
       {"illuminance_mean", "daylight_factor_mean", "uniformity_u0", "uniformity_ud"}) {
    const json number = number_of(estimate, "sensor desk", quantity);
    ASSERT_FALSE(number.is_null()) << quantity;
    EXPECT_GT(number["error"], 0) << quantity;
    EXPECT_LT(number["relative"], 1) << quantity;
  }
  for (const char* quantity : {"illuminance", "ugr", "dgp"})
    EXPECT_FALSE(number_of(estimate, "sensor eye", quantity).is_null()) << quantity;
  EXPECT_NEAR(number_of(estimate, "sensor desk", "illuminance_mean")["relative"].get<double>(),
              number_of(estimate, "sensor desk", "irradiance_mean")["relative"].get<double>(), 1e-9);
}

}  // namespace
}  // namespace etendue::estimate_test
