// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Cases with [accuracy]: what they reach, and what they leave.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::accuracy_run_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::text_of;

/// A cube of side 1 of hot gases between cold black walls, without a size of cells or directions.
std::string hot_gases(const std::string& accuracy) {
  return R"([bands]
names = ["0.1", "1", "5"]
[[mesh.box]]
region = "gas"
min = [0, 0, 0]
max = [1, 1, 1]
[media.gas]
absorption = [0.1, 1, 5]
power_density = [0.4, 4, 20]
[walls."*"]
[[probe]]
name = "middle"
points = [[0.5, 0.5, 0.5], [0.5, 0.5, 0.25]]
[output]
directory = "results"
[accuracy]
)" + accuracy;
}

json summary_of(const CaseFolder& folder) {
  return json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
}

// Powers on a wall by exact integration along rays: validation/reference/cube_hot_medium_wall_flux.csv.
TEST(Accuracy, IsReachedWithErrorsThatHold) {
  const std::map<std::string, double> exact = {{"0.1", 0.063775}, {"1", 0.446027}, {"5", 0.8423288}};
  const CaseFolder folder(hot_gases("relative = 0.02\nof = [\"wall:xmin\", \"wall:zmax\"]\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.out, "accuracy of 2 % reached for 6 numbers")) << outcome.out;
  const json summary = summary_of(folder);
  EXPECT_TRUE(summary["accuracy"]["reached"]);
  int asked = 0;
  for (const json& number : summary["estimate"]["numbers"]) {
    if (number["where"] != "wall xmin" && number["where"] != "wall zmax") continue;
    ++asked;
    const double value = number["value"], error = number["error"];
    EXPECT_LE(error, 0.02 * value) << number;
    EXPECT_LE(std::abs(value - exact.at(number["band"])), error) << number;
  }
  EXPECT_EQ(asked, 6);
  // The files are those of the last round.
  const json& rounds = summary["accuracy"]["rounds"];
  ASSERT_GE(rounds.size(), 3U);
  EXPECT_EQ(rounds.back()["cells"], summary["cells"]);
  EXPECT_EQ(rounds.back()["directions"], summary["directions"]);
  EXPECT_EQ(ScratchFolder::names_in(folder.results()),
            (std::vector<std::string>{"accuracy.csv", "estimate.csv", "fields.vtu", "history.csv", "log.txt",
                                      "probes.csv", "regions.csv", "solution.vtu", "summary.json",
                                      "walls.csv", "walls.vtp"}));
  for (const char* file : {"accuracy.csv", "estimate.csv", "log.txt"})
    EXPECT_EQ(std::ranges::count(summary["files"], json(file)), 1) << file;
}

TEST(Accuracy, WritesARowForEachRoundAndNumber) {
  const CaseFolder folder(hot_gases("relative = 0.1\nof = [\"probe:middle:1\"]\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  const test::CsvTable table(text_of(std::filesystem::path(folder.results()) / "accuracy.csv"));
  const std::size_t rounds = summary_of(folder)["accuracy"]["rounds"].size();
  ASSERT_EQ(table.rows().size(), 3 * rounds);
  EXPECT_EQ(table.column("where"), std::vector<std::string>(3 * rounds, "probe middle 1"));
  const std::vector<double> values = table.numbers("value"), allowed = table.numbers("allowed"),
                            cells = table.numbers("cells");
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_DOUBLE_EQ(allowed[i], 0.1 * values[i]);
    EXPECT_GE(cells[i], cells.front());
  }
  EXPECT_EQ(table.column("error").front(), "");
  EXPECT_LE(std::stod(table.column("error").back()), allowed.back());
}

TEST(Accuracy, EndsAtItsBudgetWithWhatIsMissing) {
  const CaseFolder folder(hot_gases("relative = 1e-6\nbudget = { minutes = 0.01 }\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::not_converged) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.out, "accuracy of 0.0001 % not reached")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "left of the budget of 0.01 minutes")) << outcome.out;
  EXPECT_TRUE(has(outcome.err, "was not reached")) << outcome.err;
  const json summary = summary_of(folder);
  EXPECT_FALSE(summary["accuracy"]["reached"]);
  EXPECT_EQ(summary["accuracy"]["rounds"].back()["cells"], summary["cells"]);
}

TEST(Accuracy, KeepsWithinItsMemory) {
  const CaseFolder folder(hot_gases("relative = 1e-6\nbudget = { memory_gb = 0.0005 }\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::not_converged) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.out, "beyond the 0.0005 GB")) << outcome.out;
}

TEST(Accuracy, EndsWhereTheIterationLeavesMore) {
  const CaseFolder folder(hot_gases("relative = 0.001\nof = [\"wall:xmin\"]\n[solve]\ntolerance = 0.01\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::not_converged) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "the iteration alone leaves more than that with solve.tolerance = 0.01"))
      << outcome.out;
  EXPECT_EQ(summary_of(folder)["accuracy"]["rounds"].size(), 1U);
}

TEST(Accuracy, TightensTheIterationForAnAmount) {
  const CaseFolder folder(hot_gases("absolute = 0.01\nof = [\"wall:xmin\"]\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  const json summary = summary_of(folder);
  for (const json& number : summary["estimate"]["numbers"])
    EXPECT_TRUE(number["where"] != "wall xmin" || number["error"] <= 0.01) << number;
}

TEST(Accuracy, SaysWhatIsWrongWithItsKeys) {
  const auto fault = [](const std::string& keys) {
    const CaseFolder folder(hot_gases(keys));
    const Outcome outcome = etendue_says({"run", folder.file()});
    EXPECT_EQ(outcome.code, ExitCode::input_error) << keys;
    EXPECT_FALSE(std::filesystem::exists(folder.results())) << keys;
    return outcome.err;
  };
  for (const auto& [keys, why] : std::vector<std::pair<std::string, std::string>>{
           {"of = [\"wall:xmin\"]\n", "give one of relative and absolute"},
           {"relative = 0.1\nabsolute = 2\n", "give one of relative and absolute"},
           {"relative = 0.1\nof = [\"floor\"]\n", "use probe:NAME, sensor:NAME"},
           {"relative = 0.1\nof = [\"sensor:desk\"]\n", "no sensor \"desk\""},
           {"relative = 0.1\nof = [\"wall:floor\"]\n", "use wall:xmax, wall:xmin"},
           {"relative = 0.1\nof = [\"probe:middle:7\"]\n", "its points are middle:0 to middle:1"},
           {"relative = 0.1\n[solve]\nmethod = \"photons\"\n", "solve.until"},
           {"relative = 0.1\n[solve]\nmethod = \"radiosity\"\n", "radiosity.refine_change"}}) {
    const std::string said = fault(keys);
    EXPECT_TRUE(has(said, why)) << keys << said;
    EXPECT_TRUE(has(said, "case.toml:")) << said;
  }
}

}  // namespace
}  // namespace etendue::accuracy_run_test
