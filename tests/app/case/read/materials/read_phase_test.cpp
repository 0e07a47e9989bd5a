// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/app/case/case_text.h"

namespace etendue::read_phase_test {
namespace {

const std::string scattering_air = cube + "[media.air]\nscattering = 1\nphase = ";  // line 9

/// The phase function of a case that stands beside a file, and what is wrong with it.
struct Beside {
  PhaseFunction phase;
  std::string faults;
};
Beside phase_beside(const std::string& phase, const std::string& name, const std::string& content) {
  const TestFolder folder;
  folder.write(name, content);
  const std::filesystem::path file = folder.write("slab.toml", scattering_air + phase + "\n");
  try {
    return {read_case(file).media.at("air").phase.front(), ""};
  } catch (const InputError& error) {
    return {{}, error.what()};
  }
}

PhaseFunction phase_of(const std::string& phase) {
  return case_of(scattering_air + phase + "\n").media.at("air").phase.front();
}

std::string phase_faults(const std::string& phase) { return faults_of(scattering_air + phase + "\n"); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(PhaseReader, ReadsEveryModel) {
  EXPECT_EQ(phase_of("{ model = \"rayleigh\" }"), PhaseFunction(PhaseRayleigh{}));
  EXPECT_EQ(phase_of("{ model = \"double-henyey-greenstein\", g1 = 0.8, g2 = -0.5, weight = 0.7 }"),
            PhaseFunction(PhaseDoubleHenyeyGreenstein{0.8, -0.5, 0.7}));
  EXPECT_EQ(phase_of("{ model = \"cornette-shanks\", g = 0.6 }"), PhaseFunction(PhaseCornetteShanks{0.6}));
  EXPECT_EQ(phase_of("{ model = \"legendre\", coefficients = [1, 0.3, 0.1] }"),
            PhaseFunction(PhaseLegendre{{1, 0.3, 0.1}}));
}

TEST(PhaseReader, ReadsAMixtureAndDividesItsSharesByTheirSum) {
  const PhaseFunction phase = phase_of(
      "{ model = \"mixture\", mix = [{ weight = 1, model = \"rayleigh\" }, { weight = 3, model = "
      "\"henyey-greenstein\", g = 0.7 }] }");
  EXPECT_EQ(phase, PhaseFunction(PhaseMixture{{0.25, 0.75}, {PhaseRayleigh{}, PhaseHenyeyGreenstein{0.7}}}));
}

TEST(PhaseReader, ReadsFilesBesideTheCase) {
  const Beside table = phase_beside("{ model = \"table\", file = \"p.csv\" }", "p.csv",
                                    "mu, p  # measured\n1, 4\n0, 2\n\n-1, 1\n");
  EXPECT_EQ(table.phase, PhaseFunction(PhaseTable({-1, 0, 1}, {1, 2, 4}))) << table.faults;
  const Beside series =
      phase_beside("{ model = \"legendre\", file = \"chi.csv\" }", "chi.csv", "1\n0.3\n0.1\n");
  EXPECT_EQ(series.phase, PhaseFunction(PhaseLegendre{{1, 0.3, 0.1}})) << series.faults;
}

TEST(PhaseReader, NamesTheLineOfAFaultyFile) {
  const std::string phase = "{ model = \"table\", file = \"p.csv\" }";
  EXPECT_TRUE(
      has(phase_beside(phase, "p.csv", "-1,1\n0,two\n1,1\n").faults, "p.csv:2: p = two: is not a number"));
  EXPECT_TRUE(has(phase_beside(phase, "p.csv", "-1,1\n1\n").faults,
                  "p.csv:2: 1 value on this line; use 2 (mu, p), between commas"));
  EXPECT_TRUE(has(phase_beside(phase, "p.csv", "0,1\n90,1\n180,1\n").faults,
                  "slab.toml:9: media.air.phase.file = \"p.csv\": mu runs from 0 to 180"));
}

TEST(PhaseReader, ReportsAFileThatCannotBeRead) {
  EXPECT_THROW(phase_of("{ model = \"table\", file = \"nowhere.csv\" }"), FileError);
}

TEST(PhaseReader, SaysWhatIsMissing) {
  EXPECT_EQ(phase_faults("{ model = \"cornette-shanks\" }"),
            "slab.toml:9: media.air.phase.g: missing; use a number above -1 and below 1");
  EXPECT_EQ(phase_faults("{ model = \"double-henyey-greenstein\", g1 = 0.5, g2 = 0.1 }"),
            "slab.toml:9: media.air.phase.weight: missing; use a number from 0 to 1");
  EXPECT_EQ(phase_faults("{ model = \"legendre\" }"),
            "slab.toml:9: media.air.phase: no moments; use coefficients or file");
  EXPECT_EQ(phase_faults("{ model = \"table\" }"),
            "slab.toml:9: media.air.phase.file: missing; use the name of a CSV file of mu and p");
  EXPECT_EQ(phase_faults("{ model = \"mixture\" }"),
            "slab.toml:9: media.air.phase.mix: missing; use a list of { weight, model, … }");
  EXPECT_EQ(phase_faults("{ model = \"mixture\", mix = [] }"),
            "slab.toml:9: media.air.phase.mix = []: is empty; use a list of { weight, model, … }");
  EXPECT_EQ(phase_faults("{ model = \"mixture\", mix = [{ model = \"rayleigh\" }] }"),
            "slab.toml:9: media.air.phase.mix[0].weight: missing; a number above 0");
}

TEST(PhaseReader, RefusesKeysOfOtherModels) {
  EXPECT_EQ(phase_faults("{ model = \"rayleigh\", g = 0.5 }"),
            "slab.toml:9: media.air.phase.g = 0.5: unused (it is no key of the model rayleigh); remove it");
  EXPECT_TRUE(has(phase_faults("{ model = \"rayleigh\", mix = [{ weight = 1, model = \"isotropic\" }] }"),
                  "unused (it is no key of the model rayleigh)"));
  EXPECT_EQ(
      phase_faults("{ model = \"mixture\", mix = [{ weight = 1, model = \"rayleigh\", g = 0.5 }] }"),
      "slab.toml:9: media.air.phase.mix[0].g = 0.5: unused (it is no key of the model rayleigh); remove it");
}

TEST(PhaseReader, RefusesSeriesThatAreNoPhaseFunctions) {
  EXPECT_TRUE(has(phase_faults("{ model = \"legendre\", coefficients = [1, 0.5] }"),
                  "slab.toml:9: media.air.phase.coefficients = [1, 0.5]: the series is negative"));
  EXPECT_TRUE(has(phase_faults("{ model = \"legendre\", coefficients = [0.5] }"), "does not begin with 1"));
}

}  // namespace
}  // namespace etendue::read_phase_test
