// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_reduced_scattering.h"

#include <gtest/gtest.h>

#include <array>

#include "app/case/values/medium_coefficients.h"
#include "base/expression/expression.h"
#include "tests/app/case/case_text.h"

namespace etendue::read_reduced_scattering_test {
namespace {

std::string air(const std::string& keys) { return cube + "[media.air]\nabsorption = 0.02\n" + keys; }
std::string two_bands(const std::string& keys) {
  return air(keys) + "[bands]\nnames = [\"red\", \"blue\"]\nedges = [700, 600, 400]\n";
}

Value scattering_of(const Case& input, int band = 0) {
  return matter_values(input.media.at("air"), band).scattering;
}

double number(const Value& value) { return std::get<double>(value); }

// Muscle of Jacques's review: mu_s' = 1 /mm at g = 0.9 is mu_s = 10 /mm.
TEST(ReadReducedScattering, DividesByOneMinusTheMeanCosine) {
  const Case input =
      case_of(air("reduced_scattering = 1\nphase = { model = \"henyey-greenstein\", g = 0.9 }\n"));
  EXPECT_NEAR(number(scattering_of(input)), 10, 1e-12);
  EXPECT_EQ(number(matter_values(input.media.at("air"), 0).absorption), 0.02);
}

// The mean cosine of two Henyey-Greenstein functions: 0.75 * 0.8 + 0.25 * (-0.4) = 0.5; of a series chi_1; of
// Rayleigh's function 0.
TEST(ReadReducedScattering, KnowsTheMeanCosineOfEveryModel) {
  const auto of = [](const std::string& phase) {
    return number(scattering_of(case_of(air("reduced_scattering = 2\nphase = " + phase + "\n"))));
  };
  EXPECT_NEAR(of("{ model = \"double-henyey-greenstein\", g1 = 0.8, g2 = -0.4, weight = 0.75 }"), 4, 1e-12);
  EXPECT_NEAR(of("{ model = \"legendre\", coefficients = [1, 0.2] }"), 2.5, 1e-12);
  EXPECT_NEAR(of("{ model = \"rayleigh\" }"), 2, 1e-12);
}

TEST(ReadReducedScattering, TakesTheMeanCosineOfEachBand) {
  const Case input = case_of(
      two_bands("reduced_scattering = 1\nphase = [{ model = \"henyey-greenstein\", g = 0.5 }, { model = "
                "\"henyey-greenstein\", g = 0.75 }]\n"));
  EXPECT_NEAR(number(scattering_of(input, 0)), 2, 1e-12);
  EXPECT_NEAR(number(scattering_of(input, 1)), 4, 1e-12);
  const Case list =
      case_of(two_bands("reduced_scattering = [1, 3]\nphase = { model = \"henyey-greenstein\", g = 0.5 }\n"));
  EXPECT_NEAR(number(scattering_of(list, 1)), 6, 1e-12);
}

TEST(ReadReducedScattering, DividesFormulas) {
  const Case input =
      case_of(air("reduced_scattering = \"1 + x\"\nphase = { model = \"henyey-greenstein\", g = 0.75 }\n"));
  const Expression formula(std::get<Formula>(scattering_of(input)).text, {"x", "y", "z"});
  EXPECT_NEAR(formula(std::array{2.0, 0.0, 0.0}), 12, 1e-12);
}

TEST(ReadReducedScattering, IsReadAgainFromTheResolvedCase) {
  const std::string resolved =
      case_of(air("reduced_scattering = 1\nphase = { model = \"henyey-greenstein\", g = 0.9 }\n"))
          .resolved_toml;
  EXPECT_EQ(faults_of(resolved), "") << resolved;
  EXPECT_NEAR(number(scattering_of(case_of(resolved))), 10, 1e-12);
}

TEST(ReadReducedScattering, IsRefusedBesideOtherKeysThatGiveScattering) {
  for (const std::string other : {"scattering = 1", "extinction = 1", "albedo = 0.5"}) {
    const std::string faults = faults_of(
        air("reduced_scattering = 1\nphase = { model = \"henyey-greenstein\", g = 0.9 }\n" + other));
    EXPECT_NE(faults.find("slab.toml:9: media.air.reduced_scattering = 1: is beside " +
                          other.substr(0, other.find(' '))),
              std::string::npos)
        << faults;
  }
}

TEST(ReadReducedScattering, NeedsAPhaseFunctionThatTurnsLight) {
  const std::string without = faults_of(air("reduced_scattering = 1\n"));
  EXPECT_NE(without.find("slab.toml:9: media.air.reduced_scattering = 1: without a phase function"),
            std::string::npos)
      << without;
  const std::string negative =
      faults_of(air("reduced_scattering = -1\nphase = { model = \"henyey-greenstein\", g = 0.9 }\n"));
  EXPECT_NE(negative.find("media.air.reduced_scattering = -1"), std::string::npos) << negative;
}

}  // namespace
}  // namespace etendue::read_reduced_scattering_test
