// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::adjoint_test {
namespace {

using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::text_of;

/// The small case with smoke that glows, a lamp along rays and sensors.
std::string lit_case() {
  std::string text = test::small_case();
  text.replace(text.find("scattering = 1.0"), 0, "emission = [0.1, 0.2, 0.3]\n");
  return text + R"([[sensor]]
name = "desk"
kind = "grid"
position = [0.2, 0.2, 0.4]
along = [0.5, 0, 0]
across = [0, 0.5, 0]
normal = [0, 0, 1]
parts = [2, 2]
[[sensor]]
name = "peak"
kind = "radiance"
position = [0.2, 0.2, 0.4]
direction = [0, 0, 1]
[[light]]
name = "lamp"
kind = "point"
position = [0.3, 0.4, 0.7]
power = [1, 2, 3]
)";
}

TEST(AdjointCommand, GivesWhatARunReads) {
  const CaseFolder folder(lit_case());
  const Outcome run = etendue_says({"run", folder.file(), "--set", "solve.tolerance=1e-11"});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const Outcome outcome =
      etendue_says({"adjoint", folder.file(), "--of", "probe:middle", "--of", "wall:floor", "--of",
                    "region:smoke", "--set", "solve.tolerance=1e-11"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  const CsvTable found(text_of(folder.path() / "results/importance.csv"));
  const CsvTable probes(text_of(folder.path() / "results/probes.csv"));
  const CsvTable walls(text_of(folder.path() / "results/walls.csv"));
  const CsvTable regions(text_of(folder.path() / "results/regions.csv"));
  const std::vector<double> irradiance = probes.numbers("irradiance");
  const std::vector<std::string> bands = {"red", "green", "blue"};
  ASSERT_EQ(irradiance.size(), bands.size());
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const auto all = [&](const std::string& response, const std::string& quantity, const std::string& unit) {
      return found.number({response, quantity, unit, "all", "", bands[b]}, "total");
    };
    const double incoming = walls.number({"floor", bands[b]}, "incoming");
    const double absorbed = regions.number({"smoke", bands[b]}, "absorbed");
    EXPECT_NEAR(all("probe:middle", "irradiance", "W/m^2"), irradiance[b], 1e-8 * irradiance[b]);
    EXPECT_NEAR(all("wall:floor", "power that arrives", "W"), incoming, 1e-8 * incoming);
    EXPECT_NEAR(all("region:smoke", "power absorbed", "W"), absorbed, 1e-8 * absorbed);
  }
  EXPECT_TRUE(has(outcome.out, "light lamp")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "region smoke")) << outcome.out;
  for (const char* name : {"importance-probe-middle.vtu", "importance-probe-middle-walls.vtp"})
    EXPECT_EQ(std::ranges::count(ScratchFolder::names_in(folder.results()), name), 1) << name;
}

// What a run reads of a probe with 1 % more and 1 % less of a coefficient.
TEST(AdjointCommand, GradientIsThatOfRuns) {
  const CaseFolder folder(lit_case() + "uncollided = false\n");
  const std::vector<std::string> tight = {"--set", "solve.tolerance=1e-11"};
  const auto says = [&](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), tight.begin(), tight.end());
    words.insert(words.end(), more.begin(), more.end());
    return etendue_says(words);
  };
  const Outcome outcome = says({"adjoint", folder.file(), "--of", "wall:floor", "--gradient"}, {});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "region smoke  absorption")) << outcome.out;
  const CsvTable found(text_of(folder.path() / "results/gradient.csv"));
  const auto incoming = [&](const std::string& change) {
    EXPECT_EQ(says({"run", folder.file()}, {"--set", change}).code, ExitCode::done);
    return CsvTable(text_of(folder.path() / "results/walls.csv")).number({"floor", "red"}, "incoming");
  };
  const auto expect = [&](const std::string& kind, const std::string& name, const std::string& by,
                          const std::string& more, const std::string& less) {
    const double up = incoming(more), down = incoming(less);
    EXPECT_NEAR(found.number({"wall:floor", kind, name, by, "red"}, "relative"),
                (up - down) / (0.01 * (up + down)), 1e-4)
        << by;
  };
  expect("region", "smoke", "absorption", "media.smoke.absorption=[0.101, 0.2, 0.3]",
         "media.smoke.absorption=[0.099, 0.2, 0.3]");
  expect("region", "smoke", "scattering", "media.smoke.scattering=1.01", "media.smoke.scattering=0.99");
  const double brought =
      incoming("media.smoke.emission=[0.101, 0.2, 0.3]") - incoming("media.smoke.emission=[0.099, 0.2, 0.3]");
  const double derivative = found.number({"wall:floor", "region", "smoke", "emission", "red"}, "derivative");
  EXPECT_NEAR(derivative, brought / 0.002, 1e-6 * derivative);
}

TEST(AdjointCommand, TakesTheMeanOfAGrid) {
  const CaseFolder folder(lit_case());
  const Outcome outcome = etendue_says({"adjoint", folder.file(), "--of", "sensor:desk"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "sensor:desk: mean irradiance [W/m^2]")) << outcome.out;
}

TEST(AdjointCommand, SaysWhatIsNotKnown) {
  const CaseFolder folder(lit_case());
  const Outcome outcome =
      etendue_says({"adjoint", folder.file(), "--of", "probe:top", "--of", "wall:zmin", "--of", "region:air",
                    "--of", "lamp", "--of", "sensor:peak", "--of", "probe:middle:1"});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  for (const char* text :
       {"--of = probe:top: no such probe; use middle", "--of = wall:zmin: no such wall; use ",
        "--of = region:air: no such region; use smoke",
        "--of = lamp: not known; use probe:NAME, sensor:NAME, wall:NAME or region:NAME",
        "--of = sensor:peak: what this sensor measures has no adjoint in this version",
        "--of = probe:middle:1: the probe has 1 points"})
    EXPECT_TRUE(has(outcome.err, text)) << text << "\n" << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder.results()));
}

TEST(AdjointCommand, RefusesWhatIsNotLinearOrNotOnDirections) {
  const CaseFolder folder(lit_case());
  const auto refused = [&](const std::string& set, const std::string& of, const std::string& text) {
    const Outcome outcome = etendue_says({"adjoint", folder.file(), "--of", of, "--set", set});
    EXPECT_EQ(outcome.code, ExitCode::input_error);
    EXPECT_TRUE(has(outcome.err, text)) << outcome.err;
  };
  refused("solve.method=\"photons\"", "probe:middle", "importance is solved for on directions");
  refused("space.positivity=\"rescale\"", "probe:middle", "space.positivity keeps values positive");
  const Outcome none = etendue_says({"adjoint", folder.file()});
  EXPECT_EQ(none.code, ExitCode::input_error);
  EXPECT_TRUE(has(none.err, "--of is required")) << none.err;
}

}  // namespace
}  // namespace etendue::adjoint_test
