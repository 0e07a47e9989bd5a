// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/json/summary.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/write/result/program_version.h"
#include "tests/app/write/sample_run.h"

namespace etendue::summary_test {
namespace {

using nlohmann::json;
using test::ScratchFolder;
using test::write_text;
using Names = std::vector<std::string>;

TEST(Summary, HoldsWhatTheContractNames) {
  test::SampleRun run({"red", "green"});
  run.solution.seconds = {0.25, 2, 0.75, 0.5, 0, 0.125};
  const json summary = json::parse(summary_json(run.result(), {"fields.vtu", "summary.json"}, 0.75));
  EXPECT_EQ(summary["title"], "Sample");
  EXPECT_EQ(summary["version"], program_version());
  EXPECT_EQ(summary["cells"], 6);
  EXPECT_EQ(summary["directions"], 24);
  EXPECT_EQ(summary["bands"], (json{"red", "green"}));
  EXPECT_EQ(summary["threads"], 2);
  EXPECT_EQ(summary["converged"], true);
  EXPECT_EQ(summary["sweeps"], (json{7, 7}));
  EXPECT_EQ(summary["residual"], (json{1e-9, 1e-9}));
  EXPECT_EQ(summary["balance"][1]["inflow"], 2);
  EXPECT_EQ(summary["negative"].size(), 2U);
  EXPECT_EQ(summary["kernels"][0]["backend"], "moments, degree 3");
  EXPECT_EQ(summary["seconds"], (json{{"read", 0.5},
                                      {"mesh", 1.5},
                                      {"setup", 0.5},
                                      {"lights", 0},
                                      {"orders", 0.25},
                                      {"sweep", 2},
                                      {"low_order_setup", 0.5},
                                      {"low_order", 0.25},
                                      {"rays", 0},
                                      {"probes", 0.25},
                                      {"sensors", 0},
                                      {"measures", 0},
                                      {"write", 0.75},
                                      {"total", 6.75}}));
  EXPECT_EQ(summary["sweep_cost"], 0);
  EXPECT_GT(summary["peak_memory"], 1 << 20);
  EXPECT_EQ(summary["case"], "title = \"Sample\"\n");
}

TEST(Summary, SaysWhichProgramMadeItWhenAndWhere) {
  const test::SampleRun run({"grey"});
  RunResult result = run.result();
  result.record = {"etendue run lamp.toml", std::chrono::sys_seconds(std::chrono::seconds(946684800))};
  const json summary = json::parse(summary_json(result, {}, 0));
  EXPECT_EQ(summary["date"], "2000-01-01T00:00:00Z");
  EXPECT_EQ(summary["host"], host_name());
  EXPECT_EQ(summary["command_line"], "etendue run lamp.toml");
  const std::string commit = summary["commit"];
  EXPECT_TRUE(commit == "unknown" || commit.find_first_not_of("0123456789abcdef") >= 40) << commit;
}

TEST(Summary, HasArraysForOneBandToo) {
  const test::SampleRun run({"grey"});
  const json summary = json::parse(summary_json(run.result(), {}, 0));
  for (const char* key : {"bands", "sweeps", "residual", "balance", "negative"})
    EXPECT_EQ(summary[key].size(), 1U) << key;
}

TEST(Summary, MarksAnInterruptedSolutionAsNotConverged) {
  test::SampleRun run({"grey"});
  run.solution.interrupted = true;
  const json summary = json::parse(summary_json(run.result(), {}, 0));
  EXPECT_EQ(summary["converged"], false);
  EXPECT_EQ(summary["interrupted"], true);
}

// No stage counts twice, and none is missing.
TEST(Summary, SecondsOfTheStagesAddUpToTheTotal) {
  test::SampleRun run({"grey"});
  run.solution.seconds = {0.25, 2, 0.75, 0.5, 0.25, 0.125};
  RunResult result = run.result();
  result.seconds = {.read = 0.5, .mesh = 1.5, .setup = 0.375, .probes = 0.25, .sensors = 1, .total = 7};
  const json seconds = json::parse(summary_json(result, {}, 0.75))["seconds"];
  double sum = 0;
  for (const auto& [name, value] : seconds.items())
    if (name != "total") sum += value.get<double>();
  EXPECT_DOUBLE_EQ(sum, 7.75);
  EXPECT_DOUBLE_EQ(seconds["total"], 7.75);
}

TEST(Summary, CountsThePicturesOfARun) {
  const ScratchFolder scratch;
  const test::SampleRun run({"grey"});
  write_text(scratch.path() / "summary.json", summary_json(run.result(), {"summary.json"}, 0.75));
  const json before = json::parse(test::text_of(scratch.path() / "summary.json"))["seconds"];
  const json after = json::parse(summary_with_files(scratch.path(), {"front.png"}, 2.5))["seconds"];
  EXPECT_EQ(after["pictures"], 2.5);
  EXPECT_EQ(after["total"].get<double>(), before["total"].get<double>() + 2.5);
  EXPECT_EQ(json::parse(summary_with_files(scratch.path(), {"front.png"}))["seconds"], before);
}

TEST(Summary, NamesWhatASignalLeftOut) {
  const test::SampleRun run({"grey"});
  RunResult result = run.result();
  result.left_out = {"3 of 5 sensors"};
  const json summary = json::parse(summary_json(result, {}, 0));
  EXPECT_EQ(summary["interrupted"], true);
  EXPECT_EQ(summary["converged"], true);
  EXPECT_EQ(summary["left_out"], json{"3 of 5 sensors"});
}

TEST(Summary, ListsTheFilesOfAnEarlierRun) {
  const ScratchFolder scratch;
  const test::SampleRun run({"grey"});
  write_text(scratch.path() / "summary.json", summary_json(run.result(), {"a.csv", "summary.json"}, 0));
  EXPECT_EQ(files_of_earlier_run(scratch.path()), (Names{"a.csv", "summary.json"}));
}

TEST(Summary, OfAnotherProgramListsNothing) {
  const ScratchFolder scratch;
  EXPECT_EQ(files_of_earlier_run(scratch.path()), Names{});
  for (const char* text :
       {"", "not JSON", "[1, 2]", R"({"files": ["a.csv"]})", R"({"program": "etendue", "files": 3})",
        R"({"program": 1, "files": ["a.csv"]})"}) {
    write_text(scratch.path() / "summary.json", text);
    EXPECT_EQ(files_of_earlier_run(scratch.path()), Names{}) << text;
  }
}

TEST(Summary, NamesNoFileOutsideItsDirectory) {
  const ScratchFolder scratch;
  write_text(scratch.path() / "summary.json",
             R"({"program": "etendue", "files": ["../a", "/b", "..", ".", "", "c.csv"]})");
  EXPECT_EQ(files_of_earlier_run(scratch.path()), Names{"c.csv"});
}

}  // namespace
}  // namespace etendue::summary_test
