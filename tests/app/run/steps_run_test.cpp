// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Steps in time. Between mirrors nothing depends on the place: n/c du/dt + sigma_a u = f(t) q.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::steps_run_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::ScratchFolder;
using test::text_of;

constexpr double slowness = 1.5 / 2, absorption = 0.5, volume = 2;
constexpr double power = 4 * std::numbers::pi * 0.25;

std::string between_mirrors(const std::string& time, const std::string& medium = "") {
  return R"([mesh]
max_volume = 0.05
[[mesh.box]]
region = "gas"
min = [0, 0, 0]
max = [1, 1, 2]
[media.gas]
absorption = 0.5
scattering = 3
emission = 0.25
refractive_index = 1.5
)" + medium +
         R"([walls."*"]
specular = 1
[directions]
set = "product"
order = 4
[[probe]]
name = "middle"
points = [[0.5, 0.5, 0.5]]
normal = [0, 0, 1]
[output]
directory = "results"
[solve]
tolerance = 1e-9
[time]
speed = 2
unit = "ns"
)" + time;
}

test::CsvTable steps_of(const CaseFolder& folder) {
  return test::CsvTable(text_of(std::filesystem::path(folder.results()) / "steps.csv"));
}

json summary_of(const CaseFolder& folder) {
  return json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
}

/// Compares all that is read of the fluence with its course.
void expect_course(const CaseFolder& folder, const std::function<double(double)>& fluence, int steps) {
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  const test::CsvTable table = steps_of(folder);
  const std::vector<std::string> quantities = table.column("quantity"), names = table.column("name");
  const std::vector<double> times = table.numbers("t"), values = table.numbers("value"),
                            errors = table.numbers("error");
  int seen = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    double factor = 1;
    if (quantities[i] == "incoming" || quantities[i] == "irradiance") continue;
    if (quantities[i] == "absorbed") factor = absorption * volume;
    if (quantities[i] == "energy") factor = slowness * volume;
    ++seen;
    EXPECT_NEAR(values[i], factor * fluence(times[i]), 2e-4 * factor * power)
        << quantities[i] << " " << names[i] << " at " << times[i];
    EXPECT_TRUE(errors[i] >= 0);
  }
  EXPECT_EQ(seen, 4 * steps);
}

TEST(StepsOfARun, FollowAStep) {
  const CaseFolder folder(between_mirrors("in_time = \"step\"\nuntil = 1\nstep = 0.05\n"));
  expect_course(
      folder, [](double t) { return power / absorption * (1 - std::exp(-absorption * t / slowness)); }, 20);
}

TEST(StepsOfARun, FollowAPulse) {
  const CaseFolder folder(between_mirrors("until = 1\nstep = 0.05\nmethod = \"bdf2\"\n"));
  expect_course(
      folder, [](double t) { return power / slowness * std::exp(-absorption * t / slowness); }, 20);
}

/// The light of f(t) = t.
double light_of_a_ramp(double t) {
  const double lag = slowness / absorption;
  return power / absorption * (t - lag * (1 - std::exp(-t / lag)));
}

TEST(StepsOfARun, FollowAFormulaOfASource) {
  const CaseFolder folder(between_mirrors("until = 1\nstep = 0.05\n", "in_time = \"t\"\n"));
  expect_course(folder, light_of_a_ramp, 20);
}

TEST(StepsOfARun, FollowATable) {
  const CaseFolder folder(between_mirrors("in_time = \"ramp.csv\"\nuntil = 1\nstep = 0.05\n"));
  std::ofstream(std::filesystem::path(folder.file()).parent_path() / "ramp.csv") << "t,factor\n0,0\n5,5\n";
  expect_course(folder, light_of_a_ramp, 20);
}

TEST(StepsOfARun, AdaptAndLeaveFrames) {
  const CaseFolder folder(
      between_mirrors("in_time = \"step\"\nuntil = 1\nstep = 1\ntolerance = 1e-3\nframes = 4\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.out, "steps in time: at least 4 of 0.25 ns, to 1 ns")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "4 frames in fluence.pvd")) << outcome.out;
  EXPECT_EQ(ScratchFolder::names_in(folder.results()),
            (std::vector<std::string>{"fields.vtu", "fluence.pvd", "fluence_0001.vtu", "fluence_0002.vtu",
                                      "fluence_0003.vtu", "fluence_0004.vtu", "history.csv", "log.txt",
                                      "probes.csv", "regions.csv", "solution.vtu", "steps.csv",
                                      "summary.json", "walls.csv", "walls.vtp"}));
  const std::string frames = text_of(std::filesystem::path(folder.results()) / "fluence.pvd");
  for (const char* time : {"0.25", "0.5", "0.75", "1"})
    EXPECT_TRUE(has(frames, std::string("timestep=\"") + time + "\"")) << frames;
  const json march = summary_of(folder)["time"]["march"];
  EXPECT_LE(march["error"], 1e-3);
  EXPECT_LE(march["imbalance"], 1e-8);
  EXPECT_EQ(march["frames"], 4);
  const CaseFolder again(summary_of(folder)["case"].get<std::string>());
  EXPECT_EQ(etendue_says({"check", again.file()}).code, ExitCode::done);
}

TEST(StepsOfARun, StandBesideTransforms) {
  const CaseFolder folder(
      between_mirrors("in_time = \"step\"\nuntil = 1\nstep = 0.05\ntimes = [1]\nmodulation = [0.2]\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  const test::CsvTable by_inversion(text_of(std::filesystem::path(folder.results()) / "times.csv"));
  const test::CsvTable by_steps = steps_of(folder);
  const double first = by_inversion.numbers("value").front();
  EXPECT_NEAR(by_steps.numbers("value")[19], first, 1e-4 * first);
  EXPECT_EQ(by_steps.numbers("t")[19], 1);
}

/// Photons find the same histories, with errors that hold.
void expect_histories_by_photons(const std::string& in_time, const std::function<double(double)>& fluence) {
  const CaseFolder folder(between_mirrors("in_time = \"" + in_time + "\"\ntimes = [0.3, 1]\n" +
                                          (in_time == "pulse" ? "window = 0.1\n" : "")));
  const Outcome outcome =
      etendue_says({"run", folder.file(), "--set", "solve={photons=2e5,method=\"photons\"}"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.out, "see times.csv (the standard error is up to")) << outcome.out;
  const test::CsvTable table(text_of(std::filesystem::path(folder.results()) / "times.csv"));
  const std::vector<std::string> quantities = table.column("quantity"), names = table.column("name");
  const std::vector<double> times = table.numbers("t"), values = table.numbers("value"),
                            errors = table.numbers("error");
  int seen = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NE(quantities[i], "irradiance");
    if (quantities[i] == "incoming") continue;
    ++seen;
    const double expected = (quantities[i] == "absorbed" ? absorption * volume : 1) * fluence(times[i]);
    EXPECT_NEAR(values[i], expected, 4 * errors[i] + 2e-4 * expected) << quantities[i] << " at " << times[i];
    EXPECT_LE(errors[i], 0.2 * expected) << quantities[i] << " at " << times[i];
  }
  EXPECT_EQ(seen, 3 * 2);
}

TEST(StepsOfARun, AreThoseOfPhotons) {
  expect_histories_by_photons(
      "step", [](double t) { return power / absorption * (1 - std::exp(-absorption * t / slowness)); });
  expect_histories_by_photons(
      "pulse", [](double t) { return power / slowness * std::exp(-absorption * t / slowness); });
}

TEST(StepsOfARun, AreComparedWithPhotons) {
  const CaseFolder folder(between_mirrors("in_time = \"step\"\ntimes = [0.3, 1]\n"));
  const Outcome outcome = etendue_says(
      {"compare", folder.file(), "--methods", "ordinates,photons", "--set", "solve.photons=1e5"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  const std::string table = text_of(std::filesystem::path(folder.results()) / "comparison.csv");
  for (const char* row :
       {"\"region gas\",\"grey\",absorbed at t = 0.3,", "\"probe middle 0\",\"grey\",fluence at t = 1,"})
    EXPECT_TRUE(has(table, row)) << table;
}

/// Mean and deviation of a decay as e^(-sigma_a c t/n) are n/(c sigma_a).
TEST(StepsOfARun, HaveTimesOfFlightBesideThem) {
  const CaseFolder folder(between_mirrors("flight_times = true\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.out, "times of flight\n")) << outcome.out;
  const test::CsvTable table(text_of(std::filesystem::path(folder.results()) / "flight_times.csv"));
  const std::vector<double> means = table.numbers("mean"), deviations = table.numbers("deviation");
  // A probe with two quantities, six walls, a region with two.
  ASSERT_EQ(means.size(), 10U);
  for (std::size_t i = 0; i < means.size(); ++i) {
    EXPECT_NEAR(means[i], slowness / absorption, 1e-6) << i;
    EXPECT_NEAR(deviations[i], slowness / absorption, 1e-6) << i;
  }
  EXPECT_EQ(table.column("unit").front(), "ns");
}

/// The formula has no value between the ends of even steps, where the first stage of a step is.
TEST(StepsOfARun, KeepWhatWasFoundBeforeAFault) {
  const CaseFolder folder(between_mirrors(
      "in_time = \"t > 0.5732 && t < 0.5733 ? 1/0 : 1\"\nuntil = 1\nstep = 0.25\nflight_times = true\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::not_converged) << outcome.out;
  EXPECT_TRUE(has(outcome.err, "steps in time ended early: ")) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "use a formula that is finite")) << outcome.err;
  EXPECT_EQ(steps_of(folder).numbers("t").size() / 11, 2U);  // numbers of 11 quantities at 0.25 and 0.5
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(folder.results()) / "flight_times.csv"));
}

/// A medium that emits nothing follows the default, a pulse, which is nothing to compare steps with.
TEST(StepsOfARun, AdaptToARampFromDarkness) {
  const CaseFolder folder(between_mirrors("until = 1\nstep = 0.1\ntolerance = 0.01\n"));
  const Outcome outcome = etendue_says({"run", folder.file(), "--set", "media.gas.emission=0", "--set",
                                        "walls.\"*\"={specular=0.5,radiance=1,in_time=\"t\"}"});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_GE(summary_of(folder)["time"]["march"]["steps"], 10);
}

struct Refusal {
  const char* time;
  const char* medium;
  const char* message;
};

TEST(StepsOfARun, AreRefusedWithTheReason) {
  const Refusal refusals[] = {
      {"times = [1]\nstep = 0.1\n", "", "there are no steps without `until`"},
      {"flight_times = true\nin_time = \"step\"\n", "", "it is for `times` and `until`"},
      {"times = [1]\nin_time = \"step\"\nwindow = 0.2\n", "", "it is for `times` after a pulse"},
      {"until = 1\nstep = 2\n", "", "time.step = 2: is longer than until"},
      {"until = 1\nmethod = \"bdf2\"\ntolerance = 1e-3\n", "", "takes even steps"},
      {"until = 1\nin_time = \"sine\"\n", "", "is neither \"pulse\", \"step\", a formula in t nor"},
      {"times = [1]\nin_time = \"2*t\"\n", "", "in_time = \"2*t\": is not for `times`"},
      {"times = [1]\nin_time = \"step\"\n", "in_time = \"pulse\"\n",
       "in_time = \"pulse\": is not for `times`"},
  };
  for (const Refusal& refusal : refusals) {
    const CaseFolder folder(between_mirrors(refusal.time, refusal.medium));
    const Outcome outcome = etendue_says({"check", folder.file()});
    EXPECT_EQ(outcome.code, ExitCode::input_error) << refusal.time;
    EXPECT_TRUE(has(outcome.err, refusal.message)) << outcome.err;
  }
  std::string steady = between_mirrors("until = 1\n", "in_time = \"step\"\n");
  steady.erase(steady.find("[time]"));
  EXPECT_TRUE(has(etendue_says({"check", CaseFolder(steady).file()}).err,
                  "in_time = \"step\": is of no use in a case without [time]"));
}

/// Known before anything is solved, and to a check too.
TEST(StepsOfARun, RefuseWhatTheyCannotFollow) {
  for (const char* command : {"check", "run"}) {
    const CaseFolder endless(between_mirrors("until = 1\nin_time = \"1/(t-1)\"\nstep = 0.25\n"));
    const Outcome outcome = etendue_says({command, endless.file()});
    EXPECT_EQ(outcome.code, ExitCode::input_error) << command;
    EXPECT_TRUE(has(outcome.err, "use a formula that is finite and not below 0")) << outcome.err;
  }
  const CaseFolder folder(between_mirrors("until = 1\n"));
  const Outcome outcome = etendue_says({"check", folder.file(), "--set", "walls.\"*\".radiance=1"});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "sends a pulse in, which would last as long as a step")) << outcome.err;
  const Outcome rotated = etendue_says({"run", folder.file(), "--set", "directions.set=\"ldfe-sq\"", "--set",
                                        "directions.order=1", "--set", "directions.rotations=2"});
  EXPECT_EQ(rotated.code, ExitCode::input_error);
  EXPECT_TRUE(has(rotated.err, "steps along one set of directions")) << rotated.err;
}

}  // namespace
}  // namespace etendue::steps_run_test
