// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Cases with [time]. Between mirrors nothing depends on the place, and all is known in closed form:
// the fluence of a source q is 4 pi q / (sigma_a + s n / c).
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::time_run_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::text_of;

constexpr double slowness = 1.5 / 2, power = 4 * std::numbers::pi * 0.25;
constexpr double absorption_of[] = {0.5, 2};

/// A box of volume 2 between mirrors; light goes 2/1.5 in one unit of time.
std::string between_mirrors(const std::string& time) {
  return R"([bands]
names = ["thin", "thick"]
[mesh]
max_volume = 0.05
[[mesh.box]]
region = "gas"
min = [0, 0, 0]
max = [1, 1, 2]
[media.gas]
absorption = [0.5, 2]
scattering = [3, 1]
emission = 0.25
refractive_index = 1.5
[walls."*"]
specular = 1
[directions]
set = "product"
order = 4
[[probe]]
name = "middle"
points = [[0.5, 0.5, 0.5]]
normal = [0, 0, 1]
[[sensor]]
name = "eye"
kind = "fluence"
position = [0.3, 0.6, 1.2]
[[sensor]]
name = "view"
kind = "cone"
position = [0.5, 0.5, 1]
direction = [0, 0, 1]
angle = 20
[output]
directory = "results"
[solve]
tolerance = 1e-9
[time]
speed = 2
unit = "ns"
)" + time;
}

test::CsvTable table_of(const CaseFolder& folder, const char* file) {
  return test::CsvTable(text_of(std::filesystem::path(folder.results()) / file));
}

std::size_t band_of(const std::string& name) { return name == "thick" ? 1 : 0; }

/// What a fluence makes of the quantity of a row; walls are not looked at.
double factor_of(const std::string& quantity, std::size_t band) {
  if (quantity == "absorbed") return 2 * absorption_of[band];
  return quantity == "irradiance" ? 0.25 : 1;
}

TEST(Time, GivesAmplitudeAndPhaseAtFrequencies) {
  const CaseFolder folder(between_mirrors("modulation = [0.1, 2]\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.out, "light in time: 3 rates are solved for, 3 side by side")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "sensors that do not read it: view")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "modulated light: 22 numbers at 2 frequencies, see frequency.csv"))
      << outcome.out;
  const test::CsvTable table = table_of(folder, "frequency.csv");
  const std::vector<std::string> quantities = table.column("quantity"), names = table.column("name"),
                                 bands = table.column("band");
  const std::vector<double> frequencies = table.numbers("frequency"), amplitudes = table.numbers("amplitude"),
                            phases = table.numbers("phase"), modulations = table.numbers("modulation");
  int seen = 0;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (names[i].starts_with("wall")) continue;
    ++seen;
    const std::size_t band = band_of(bands[i]);
    const std::complex<double> rate(0, 2 * std::numbers::pi * frequencies[i]);
    const std::complex<double> expected = power / (absorption_of[band] + rate * slowness);
    const double amplitude = factor_of(quantities[i], band) * std::abs(expected);
    // The directions' half range is not that of the sphere to the last digit.
    EXPECT_NEAR(amplitudes[i], amplitude, (quantities[i] == "irradiance" ? 0.05 : 1e-7) * amplitude)
        << names[i];
    EXPECT_NEAR(phases[i], -std::arg(expected) * 180 / std::numbers::pi, 1e-5) << names[i];
    EXPECT_NEAR(modulations[i], std::abs(expected) * absorption_of[band] / power, 1e-7) << names[i];
  }
  // A probe with two quantities, a sensor, a region with two; two bands, three frequencies.
  EXPECT_EQ(seen, 5 * 2 * 3);
}

void expect_history(const std::string& in_time, const std::function<double(double, double)>& expected) {
  const CaseFolder folder(
      between_mirrors("in_time = \"" + in_time + "\"\ntimes = [0.02, 0.15, 0.5, 1.0, 1.5]\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  // Times of two decades.
  EXPECT_TRUE(has(outcome.out, "light in time: 82 rates are solved for, 4 side by side")) << outcome.out;
  const test::CsvTable table = table_of(folder, "times.csv");
  const std::vector<std::string> quantities = table.column("quantity"), names = table.column("name"),
                                 bands = table.column("band");
  const std::vector<double> times = table.numbers("t"), values = table.numbers("value"),
                            errors = table.numbers("error");
  int seen = 0;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (names[i].starts_with("wall") || quantities[i] == "irradiance") continue;
    ++seen;
    const std::size_t band = band_of(bands[i]);
    const double exact = factor_of(quantities[i], band) * expected(absorption_of[band], times[i]);
    const double most = factor_of(quantities[i], band) * power / std::min(slowness, absorption_of[band]);
    EXPECT_NEAR(values[i], exact, 2e-5 * most) << names[i] << " at " << times[i];
    EXPECT_LE(errors[i], 1e-4 * most) << names[i] << " at " << times[i];
  }
  EXPECT_EQ(seen, 4 * 2 * 5);
}

TEST(Time, FollowsAPulse) {
  expect_history("pulse", [](double absorption, double t) {
    return power / slowness * std::exp(-absorption * t / slowness);
  });
}

TEST(Time, FollowsAStep) {
  expect_history("step", [](double absorption, double t) {
    return power / absorption * (1 - std::exp(-absorption * t / slowness));
  });
}

TEST(Time, LeavesWholeFilesThatNameThemselves) {
  const CaseFolder folder(between_mirrors("modulation = [0.1]\ntimes = [1]\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  EXPECT_EQ(
      ScratchFolder::names_in(folder.results()),
      (std::vector<std::string>{"fields.vtu", "frequency.csv", "history.csv", "log.txt", "modulation.vtu",
                                "probes.csv", "regions.csv", "sensors.csv", "solution.vtu", "summary.json",
                                "times.csv", "walls.csv", "walls.vtp"}));
  const std::string fields = text_of(std::filesystem::path(folder.results()) / "modulation.vtu");
  for (const char* array : {"amplitude_0", "amplitude_0.1", "phase_0.1"})
    EXPECT_TRUE(has(fields, std::string("\"") + array + "\"")) << array;
  const json summary = json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
  EXPECT_EQ(summary["time"]["rates"], 2 + 41);
  EXPECT_TRUE(summary["time"]["converged"]);
  // The case that is kept is this one, and can be run again.
  const CaseFolder again(summary["case"].get<std::string>());
  EXPECT_EQ(etendue_says({"check", again.file()}).code, ExitCode::done);
}

TEST(Time, IsSolvedForByTheRunAlone) {
  const CaseFolder folder(between_mirrors("modulation = [0.1]\n"));
  const Outcome outcome = etendue_says({"run", folder.file(), "--estimate"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  const std::size_t first = outcome.out.find("light in time: 2 rates");
  ASSERT_NE(first, std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("light in time: 2 rates", first + 1), std::string::npos) << outcome.out;
}

/// Histories take more sweeps than the steady light of a loose tolerance.
TEST(Time, EndsWithoutConvergenceAsTheRunDoes) {
  const CaseFolder folder(between_mirrors("times = [1]\n"));
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "solve.max_sweeps=6", "--set",
                                        "solve.tolerance=0.3", "--set", "walls.\"*\".specular=0"});
  EXPECT_EQ(outcome.code, ExitCode::not_converged) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.err, "light in time is not converged")) << outcome.err;
  EXPECT_EQ(outcome.out.find("grey NOT converged"), std::string::npos);
  const json summary = json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
  EXPECT_TRUE(summary["converged"]);
  EXPECT_FALSE(summary["time"]["converged"]);
}

/// A wall that emits and takes all light: at later times of a pulse nothing is left but what scatters back.
TEST(Time, HasNumbersEverywhereAfterAPulse) {
  const CaseFolder folder(between_mirrors("times = [0.5, 4]\n"));
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "walls.\"*\".specular=0", "--set",
                                        "walls.\"*\".radiance=1", "--set", "media.gas.emission=0"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  const test::CsvTable table = table_of(folder, "times.csv");
  const std::vector<double> times = table.numbers("t"), values = table.numbers("value"),
                            errors = table.numbers("error");
  ASSERT_FALSE(values.empty());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_TRUE(std::isfinite(values[i]) && std::isfinite(errors[i]));
    // No light is left that is older than some free paths.
    if (times[i] == 4) {
      EXPECT_LT(std::abs(values[i]), 1e-2) << i;
    }
  }
}

struct Fault {
  const char* time;
  const char* message;
};

TEST(Time, RefusesWhatItCannotDo) {
  const Fault faults[] = {
      {"", "time: asks for nothing; give modulation, times, until or flight_times"},
      {"times = [1, 1]\n", "time.times = [1, 1]: must rise throughout"},
      {"modulation = []\n", "time.modulation = []: is empty; use a list of numbers, each above 0"},
      {"times = [-1]\n", "time.times"},
      {"times = [1]\nin_time = \"sine\"\n", "time.in_time = \"sine\""},
      {"times = [1]\n[accuracy]\nrelative = 0.1\n", "time: not beside [accuracy] in this version"},
      {"times = [1]\n[space]\npositivity = \"rescale\"\n", "time: not with values kept positive"},
  };
  for (const Fault& fault : faults) {
    const CaseFolder folder(between_mirrors(fault.time));
    const Outcome outcome = etendue_says({"check", folder.file()});
    EXPECT_EQ(outcome.code, ExitCode::input_error) << fault.time;
    EXPECT_TRUE(has(outcome.err, fault.message)) << outcome.err;
  }
  const CaseFolder photons(between_mirrors("modulation = [1]\n"));
  EXPECT_TRUE(has(etendue_says({"check", photons.file(), "--set", "solve.method=\"photons\""}).err,
                  "time: photons know `times` alone"));
}

TEST(Time, IsWhatARefractiveIndexOfAMediumNeeds) {
  std::string text = between_mirrors("times = [1]\n");
  text.erase(text.find("[time]"));
  const CaseFolder folder(text);
  EXPECT_TRUE(
      has(etendue_says({"check", folder.file()}).err, "has a refractive_index in a case without [time]"));
}

}  // namespace
}  // namespace etendue::time_run_test
