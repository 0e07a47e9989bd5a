// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Temperatures that change with time, from the case to the files.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/blackbody.h"
#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::heat_steps_run_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::text_of;

std::string box_of_gas(const std::string& gas, const std::string& walls, const std::string& time) {
  return R"([mesh]
max_volume = 0.1
[[mesh.box]]
region = "gas"
min = [0, 0, 0]
max = [1, 1, 1]
[media.gas]
)" + gas +
         R"(
[walls."*"]
)" + walls +
         R"(
[directions]
set = "product"
order = 2
[[probe]]
name = "middle"
points = [[0.5, 0.5, 0.5]]
[output]
directory = "results"
[solve]
tolerance = 1e-9
)" + (time.empty() ? "" : "[time]\n" + time);
}

/// Values of a quantity at the ends of steps.
std::vector<double> values_of(const CaseFolder& folder, const std::string& quantity,
                              const std::string& name) {
  const test::CsvTable table(text_of(std::filesystem::path(folder.results()) / "steps.csv"));
  const std::vector<std::string> quantities = table.column("quantity"), names = table.column("name");
  const std::vector<double> all = table.numbers("value");
  std::vector<double> values;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (quantities[i] == quantity && names[i] == name) values.push_back(all[i]);
  return values;
}

json summary_of(const CaseFolder& folder) {
  return json::parse(text_of(std::filesystem::path(folder.results()) / "summary.json"));
}

// Insulated: c dT/dt = s (1 + t/10).
TEST(HeatStepsRun, HeatsAnInsulatedBox) {
  const CaseFolder folder(box_of_gas(
      "absorption = 0.5\nheat_source = 2000\nheat_capacity = 40\ninitial_temperature = 500\nin_time = "
      "\"1+t/10\"",
      "emissivity = 0.8\nheat_flux = 0", "until = 10\nstep = 2.5\nframes = 2\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.out << outcome.err;
  for (const char* name : {"region gas", "wall zmin", "probe middle 0"}) {
    const std::vector<double> temperatures = values_of(folder, "temperature", name);
    ASSERT_EQ(temperatures.size(), 4u) << name;
    for (std::size_t step = 0; step < 4; ++step) {
      const double t = 2.5 * static_cast<double>(step + 1);
      EXPECT_NEAR(temperatures[step], 500 + 50 * (t + t * t / 20), 1e-3) << name;
    }
  }
  EXPECT_NEAR(values_of(folder, "stored_heat", "all").back() / 30000, 1, 1e-6);
  const json march = summary_of(folder)["time"]["march"];
  EXPECT_EQ(march["steps"], 4);
  EXPECT_EQ(march["frames"], 2);
  EXPECT_LT(march["imbalance"], 1e-6);
  for (const char* file : {"temperature.pvd", "temperature_0001.vtu", "temperature_0002.vtu"})
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(folder.results()) / file)) << file;
  EXPECT_TRUE(has(outcome.out, "steps: 4 of 2.5 s, to 10 s")) << outcome.out;
}

// The temperatures that a run ends with are those that the next one begins with.
TEST(HeatStepsRun, GoesOnFromASolution) {
  const auto text = [](const std::string& time) {
    return box_of_gas(
        "absorption = 1\nconductivity = 2\nheat_capacity = 1000\ninitial_temperature = \"900+300*z\"",
        "emissivity = 0.8\ntemperature = 400", time);
  };
  const CaseFolder whole(text("until = 40\nstep = 5\n")), half(text("until = 20\nstep = 5\n"));
  ASSERT_EQ(etendue_says({"run", whole.file()}).code, ExitCode::done);
  ASSERT_EQ(etendue_says({"run", half.file()}).code, ExitCode::done);
  const Outcome rest =
      etendue_says({"run", half.file(), "--set", "solve.initial=\"" + half.results() + "/solution.vtu\"",
                    "--output", half.results() + "/rest"});
  ASSERT_EQ(rest.code, ExitCode::done) << rest.out << rest.err;
  const test::CsvTable table(text_of(std::filesystem::path(half.results()) / "rest" / "steps.csv"));
  const std::vector<double> at_once = values_of(whole, "temperature", "region gas");
  ASSERT_EQ(at_once.size(), 8u);
  std::vector<double> in_two;
  for (std::size_t i = 0; i < table.column("name").size(); ++i)
    if (table.column("name")[i] == "region gas" && table.column("quantity")[i] == "temperature")
      in_two.push_back(table.numbers("value")[i]);
  ASSERT_EQ(in_two.size(), 4u);
  for (std::size_t step = 0; step < 4; ++step) EXPECT_NEAR(in_two[step], at_once[step + 4], 1e-4);
}

TEST(HeatStepsRun, RefusesWhatDoesNotSuit) {
  const std::string gas = "absorption = 1\nheat_capacity = 10\ninitial_temperature = 500\n";
  const std::string wall = "temperature = 400\n";
  struct Faulty {
    std::string gas, walls, time, message;
  };
  const std::vector<Faulty> cases = {
      {gas, wall, "", "without [time]"},
      {gas, wall, "until = 1\nspeed = 3e8\n", "leave speed out"},
      {gas, wall, "until = 1\nunit = \"ns\"\n", "seconds"},
      {gas, wall, "times = [1]\n", "by steps alone"},
      {"absorption = 1\nheat_capacity = 10\n", wall, "until = 1\n", "needs initial_temperature"},
      {"absorption = 1\nheat_source = 10\n", "heat_flux = 0\nheat_capacity = 10\ninitial_temperature = 300\n",
       "until = 1\n", "give heat_capacity"},
      {"absorption = 1\ntemperature = 500\n", "heat_flux = 10\nin_time = \"pulse\"\n", "until = 1\n",
       "not of heat_flux"},
      {"absorption = 1\ntemperature = 500\n", wall, "until = 1\n", "heat_capacity"},
      {gas + "in_time = \"1+t\"\n", wall, "until = 1\n", "heat_source"},
      {gas + "heat_source = 1\nin_time = \"pulse\"\n", wall, "until = 1\n", "not of heat_source"},
      {gas, wall + "heat_capacity = 5\n", "until = 1\n", "does not follow"},
      {"absorption = 1\nheat_capacity = \"10*q\"\n", wall, "until = 1\n", "x, y, z, T"},
      {"absorption = 1\nheat_capacity = \"10-T\"\ninitial_temperature = 300\n", wall, "until = 1\n",
       "use at least 0"}};
  for (const Faulty& faulty : cases) {
    const CaseFolder folder(box_of_gas(faulty.gas, faulty.walls, faulty.time));
    const Outcome outcome = etendue_says({"run", folder.file()});
    EXPECT_EQ(outcome.code, ExitCode::input_error) << faulty.message << outcome.out;
    EXPECT_TRUE(has(outcome.err, faulty.message)) << faulty.message << "\n" << outcome.err;
  }
}

// A wall far from balance: steps adapt where the case says nothing of them, and long even ones are cautioned
// of.
TEST(HeatStepsRun, AdaptsUnlessStepsAreGiven) {
  const auto text = [](const std::string& time) {
    return box_of_gas("absorption = 0",
                      "emissivity = 0.8\nheat_flux = 0\nheat_capacity = 1e3\ninitial_temperature = 300\n"
                      "[walls.zmax]\nemissivity = 1\ntemperature = 1300",
                      time);
  };
  const CaseFolder adapted(text("until = 360\n")), even(text("until = 360\nstep = 36\n"));
  const Outcome one = etendue_says({"run", adapted.file()}), other = etendue_says({"run", even.file()});
  ASSERT_EQ(one.code, ExitCode::done) << one.out << one.err;
  for (const double kelvin : values_of(adapted, "temperature", "wall zmin")) EXPECT_LT(kelvin, 1300);
  EXPECT_FALSE(has(one.out, "steps are so long")) << one.out;
  EXPECT_TRUE(has(other.out, "steps are so long")) << other.out;
}

// What fails at a later step leaves the steps before it.
TEST(HeatStepsRun, KeepsTheStepsBeforeAFault) {
  const CaseFolder folder(
      box_of_gas("absorption = 0.5\nheat_source = 2000\nheat_capacity = 40\ninitial_temperature = 500\n"
                 "conductivity = \"800-T\"",
                 "emissivity = 0.8\nheat_flux = 0", "until = 10\nstep = 1\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::not_converged) << outcome.out << outcome.err;
  EXPECT_TRUE(has(outcome.err, "conductivity")) << outcome.err;
  const std::vector<double> temperatures = values_of(folder, "temperature", "region gas");
  ASSERT_GE(temperatures.size(), 4u);
  EXPECT_LE(temperatures.back(), 800);
}

}  // namespace
}  // namespace etendue::heat_steps_run_test
