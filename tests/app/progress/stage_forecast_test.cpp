// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What stages say of the time that is left, and what `seconds` adds up to.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/progress/stage_progress.h"
#include "tests/app/run/small_case.h"

namespace etendue::stage_forecast_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::etendue_says;
using test::Outcome;
using test::text_of;

/// "NAME: 12 %, about 34 s left", the last of a text; negative where there is none.
double seconds_left_in(const std::string& text) {
  const std::size_t at = text.rfind("about ");
  return at == std::string::npos ? -1 : std::stod(text.substr(at + 6));
}

// Time as a function of the share: even, faster and slower towards the end, and with a start of its own.
TEST(StageForecast, IsWithinAFactorTwoAfterATenth) {
  struct Course {
    const char* name;
    double (*seconds)(double share);
  };
  for (const Course& course :
       {Course{"even", [](double share) { return 100 * share; }},
        Course{"slower", [](double share) { return 80 * share + 20 * share * share; }},
        Course{"faster", [](double share) { return 120 * share - 20 * share * share; }},
        Course{"after preparation", [](double share) { return 60 + 100 * share; }}})
    for (int percent = 10; percent < 100; percent += 5) {
      std::ostringstream out;
      StageProgress display(ProgressStyle::plain, "sensors", out);
      display.show(0.001, course.seconds(0.001));
      const double share = percent / 100.0, truth = course.seconds(1) - course.seconds(share);
      display.show(share, course.seconds(share));
      const double said = seconds_left_in(out.str());
      EXPECT_GE(said, truth / 2 - 0.5) << course.name << " " << percent << " %: " << out.str();
      EXPECT_LE(said, truth * 2 + 0.5) << course.name << " " << percent << " %: " << out.str();
    }
}

// A stage in which each part takes the time that it sleeps, whatever else the machine does beside: sleeping
// takes no processor.
TEST(StageForecast, OfAStageThatRunsIsWithinAFactorTwo) {
  std::ostringstream out;
  constexpr int parts = 40;
  const auto begun = std::chrono::steady_clock::now();
  const auto since = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  };
  std::vector<std::array<double, 2>> said;  // when, and what was left then
  {
    ShownStage stage({ProgressStyle::bar, out, {}}, "sensors");
    StageCounter counter(parts, stage.observer());
    for (int part = 0; part < parts; ++part) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      counter.add();
      if (part >= parts / 10) said.push_back({since(), seconds_left_in(out.str())});
    }
  }
  const double total = since();
  for (const auto& [when, left] : said) {
    if (left < 0) continue;
    const double truth = total - when;
    // Seconds are printed whole, and a drawing may be 0.2 s old.
    EXPECT_LE(left, 2 * truth + 1.5) << when;
    EXPECT_GE(left, truth / 2 - 1.5) << when;
  }
}

TEST(ShownStage, ShowsThatItGoesOnWhereItSaysNothing) {
  std::ostringstream out;
  {
    const ShownStage stage({ProgressStyle::plain, out, {}}, "meshing");
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  }
  EXPECT_TRUE(out.str().starts_with("  meshing: 1 s so far\n") ||
              out.str().starts_with("  meshing: 2 s so far\n"))
      << out.str();
}

TEST(ShownStage, IsSilentWhereItIsShort) {
  std::ostringstream out;
  { const ShownStage stage({ProgressStyle::plain, out, {}}, "meshing"); }
  EXPECT_EQ(out.str(), "");
}

// A picture of seconds without gathering: what gathers must not go on saying so beside the picture.
TEST(ShownStage, OfGatheringIsOverWhereNothingIsGathered) {
  const CaseFolder folder(test::small_case() +
                          "[[camera]]\nname = \"front\"\nposition = [0.5, 0.1, 0.5]\n"
                          "look_at = [0.5, 0.9, 0.5]\npixels = [450, 450]\nsamples = 9\n");
  const Outcome outcome = etendue_says({"run", folder.file(), "--progress", "plain"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(test::has(outcome.out, "picture front: ")) << outcome.out;
  EXPECT_FALSE(test::has(outcome.out, "looking for the light of walls")) << outcome.out;
}

/// Expects that all entries but the total add up to it.
void expect_sum(const CaseFolder& folder, const std::string& said) {
  const json seconds =
      json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"))["seconds"];
  double sum = 0;
  for (const auto& [name, value] : seconds.items())
    if (name != "total") sum += value.get<double>();
  const double total = seconds["total"];
  EXPECT_NEAR(sum, total, std::max(0.02 * total, 0.005)) << said;
}

constexpr const char* with_everything = R"(
[[light]]
kind = "point"
name = "lamp"
position = [0.5, 0.5, 0.7]
power = 1
[[sensor]]
kind = "irradiance"
name = "meter"
position = [0.5, 0.5, 0.2]
normal = [0, 0, 1]
[[camera]]
name = "front"
position = [0.5, 0.1, 0.5]
look_at = [0.5, 0.9, 0.5]
pixels = [32, 32]
)";

TEST(StageSeconds, AddUpToTheTotalWithinTwoPercent) {
  const CaseFolder folder(test::small_case() + with_everything);
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--set", "mesh.max_volume=1e-3", "--set", "directions.order=8"},
        std::vector<std::string>{"--estimate"},
        std::vector<std::string>{"--set", "solve.method='photons'", "--set", "solve.photons=20000"}}) {
    std::vector<std::string> arguments = {"run", folder.file()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = etendue_says(arguments);
    ASSERT_TRUE(outcome.code == ExitCode::done || outcome.code == ExitCode::not_converged) << outcome.err;
    expect_sum(folder, outcome.out);
  }
}

TEST(StageSeconds, OfRadiosityAddUpToo) {
  const CaseFolder room(
      "[mesh]\nmax_volume = 0.02\n[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
      "walls = { zmin = \"floor\" }\n[media.air]\n[walls.floor]\nradiance = 1\n[walls.'*']\ndiffuse = 0.5\n"
      "[solve]\nmethod = \"radiosity\"\n[output]\ndirectory = \"results\"\n");
  const Outcome outcome = etendue_says({"run", room.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  expect_sum(room, outcome.out);
}

}  // namespace
}  // namespace etendue::stage_forecast_test
