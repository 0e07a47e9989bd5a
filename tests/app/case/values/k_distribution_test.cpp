// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/k_distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/case/build/build.h"
#include "base/blackbody.h"
#include "base/errors.h"
#include "tests/app/case/case_text.h"

namespace etendue::k_distribution_test {
namespace {

const std::string two_points =
    "temperature,absorption,weight\n300,0.1,0.75\n300,5,0.25\n1300,0.3,0.5\n1300,4,0.5\n";

std::string fault_of(const std::string& content) {
  const TestFolder folder;
  try {
    k_distribution(folder.write("k.csv", content));
  } catch (const InputError& error) {
    return error.faults().front().text;
  }
  return "";
}

TEST(KDistribution, HasAGasForEachPoint) {
  const TestFolder folder;
  const GrayGases mixture = k_distribution(folder.write("k.csv", two_points));
  ASSERT_EQ(mixture.gases.size(), 2u);
  EXPECT_EQ(mixture.lowest, 300);
  EXPECT_EQ(mixture.highest, 1300);
  EXPECT_DOUBLE_EQ(mixture.gases[0].absorption.at(300), 0.1);
  EXPECT_DOUBLE_EQ(mixture.gases[0].absorption.at(800), 0.2);
  EXPECT_DOUBLE_EQ(mixture.gases[1].absorption.at(1300), 4);
  EXPECT_DOUBLE_EQ(mixture.gases[0].weight.at(800), 0.625);
  EXPECT_DOUBLE_EQ(mixture.gases[1].weight.at(800), 0.375);
}

TEST(KDistribution, AddsUpToOneWhereWeightsAreRounded) {
  const TestFolder folder;
  const GrayGases mixture =
      k_distribution(folder.write("k.csv", "400,1,0.33333\n400,2,0.33333\n400,3,0.33333\n"));
  ASSERT_EQ(mixture.gases.size(), 3u);
  for (const GrayGas& gas : mixture.gases) EXPECT_NEAR(gas.weight.at(400), 1.0 / 3, 1e-15);
}

TEST(KDistribution, AbsorbsAlikeWhereAFileRoundsTheSame) {
  const TestFolder folder;
  const GrayGases mixture = k_distribution(folder.write("k.csv", "300,0.3,1\n400,0.30000000001,1\n"));
  ASSERT_EQ(mixture.gases.size(), 1u);
  EXPECT_TRUE(mixture.gases.front().absorption.is_constant());
}

TEST(KDistribution, RefusesWhatIsNone) {
  EXPECT_EQ(fault_of("temperature,absorption,weight\n"),
            "has no lines of temperature, absorption and weight between commas");
  EXPECT_EQ(fault_of("300,1,0.4\n300,2,0.5\n"),
            "the weights at 300 K add up to 0.9; they are fractions of a blackbody's power, and add up to 1");
  EXPECT_EQ(fault_of("300,-1,1\n"), "has an absorption of -1; use values of at least 0");
  EXPECT_EQ(fault_of("300,1,-1\n300,1,2\n"), "has a weight of -1; use values of at least 0");
  EXPECT_NE(fault_of("300,1,0.5\n300,2,0.5\n400,1,1\n").find("400 K has not 2 lines, as 300 K has"),
            std::string::npos);
  EXPECT_NE(fault_of("300,1,0.5\n300,2,0.5\n400,1,0.5\n500,1,0.5\n").find("400 K has not 2 lines"),
            std::string::npos);
  EXPECT_NE(fault_of("400,1,1\n300,1,1\n").find("300 K is not above 400 K before it"), std::string::npos);
  EXPECT_NE(fault_of("0,1,1\n").find("0 K is not above 0"), std::string::npos);
  std::string long_file;
  for (int point = 0; point < 65; ++point) long_file += "300,1,0\n";
  EXPECT_NE(fault_of(long_file).find("has 65 points"), std::string::npos);
}

std::string case_with(const TestFolder& folder, const std::string& medium) {
  folder.write("k.csv", two_points);
  return cube + "[bands]\nk_distribution = \"" + (folder.path() / "k.csv").string() + "\"\n[media.air]\n" +
         medium;
}

double blackbody(double kelvin) { return stefan_boltzmann / std::numbers::pi * std::pow(kelvin, 4); }

TEST(KDistribution, MakesEachPointABand) {
  const TestFolder folder;
  const Case input = case_of(case_with(folder, "gas_pressure = 0.5\nabsorption = 0.02\ntemperature = 800\n"));
  EXPECT_EQ(input.bands.names, (std::vector<std::string>{"gray-1", "gray-2"}));
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  EXPECT_NEAR(problem.absorption(CellIndex(0), 0), 0.02 + 0.5 * 0.2, 1e-14);
  EXPECT_NEAR(problem.absorption(CellIndex(0), 1), 0.02 + 0.5 * 4.5, 1e-14);
  EXPECT_NEAR(problem.emission(CellIndex(0), 0), 0.12 * 0.625 * blackbody(800), 1e-9);
  EXPECT_NEAR(problem.emission(CellIndex(0), 1), 2.27 * 0.375 * blackbody(800), 1e-9);
}

TEST(KDistribution, AbsorbsByTheTemperatureOfThePlace) {
  const TestFolder folder;
  const Case input = case_of(case_with(folder, "gas_pressure = 1\ntemperature = \"800 + 0*x\"\n"));
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  EXPECT_NEAR(problem.absorption(CellIndex(0), 0), 0.2, 1e-12);
  EXPECT_NEAR(problem.absorption(CellIndex(0), 1), 4.5, 1e-12);
}

TEST(KDistribution, SaysNothingOfAbsorptionWhereTheTemperatureIsFaulty) {
  const TestFolder folder;
  for (const char* wrong :
       {"temperature = -5\n", "temperature = \"1 +\"\n", "temperature = 5\nemission = 1\n"})
    try {
      case_of(case_with(folder, std::string("gas_pressure = 1\n") + wrong));
      ADD_FAILURE() << wrong << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.faults().size(), 1u) << wrong << error.what();
    }
}

TEST(KDistribution, NamesTheKeyAndTheFileOfAFault) {
  const TestFolder folder;
  const auto file = folder.write("bad.csv", "300,1,0.5\n");
  try {
    case_of(cube + "[bands]\nk_distribution = \"" + file.string() + "\"\n");
    FAIL() << "was accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 1u) << error.what();
    EXPECT_NE(error.faults().front().text.find("bad.csv: the weights at 300 K add up to 0.5"),
              std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("bands.k_distribution"), std::string::npos);
  }
}

TEST(KDistribution, NeedsATemperatureWhereAbsorptionFollowsIt) {
  const TestFolder folder;
  const std::string text = case_with(folder, "gas_pressure = 1\nheat_source = 1e4\n");
  try {
    case_of(text);
    FAIL() << "was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(error.faults().front().text.find("absorb by the temperature, which is not given here"),
              std::string::npos);
  }
}

TEST(KDistribution, NamesTheKeyOfAFileThatIsNotThere) {
  try {
    case_of(cube + "[bands]\nk_distribution = \"none.csv\"\n");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("bands.k_distribution = \"none.csv\": "), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace etendue::k_distribution_test
