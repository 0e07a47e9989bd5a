// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "solver/materials/phase/mie_scattering.h"
#include "tests/app/case/case_text.h"

namespace etendue::read_mie_test {
namespace {

std::string one_band(const std::string& phase) {
  return cube + "[media.air]\nscattering = 1\nphase = " + phase + "\n";
}

std::string two_bands(const std::string& phase) {
  return one_band(phase) + "[bands]\nnames = [\"red\", \"blue\"]\nedges = [700, 600, 400]\n";
}

TEST(ReadMie, ComputesThePhaseFunctionOfSpheres) {
  const Case read = case_of(
      one_band("{ model = \"mie\", radius = 0.3, index = 1.33, absorption_index = 0.1, wavelength = 0.6 }"));
  const MieScattering cloud = mie_scattering(OneSize{0.3}, {1.33, 0.1}, 0.6);
  EXPECT_EQ(read.media.at("air").phase[0], PhaseFunction(cloud.phase));
  ASSERT_EQ(read.media.at("air").phase_notes.size(), 1u);
  EXPECT_EQ(read.media.at("air").phase_notes[0].find("spheres at wavelength 0.6: Q_ext = "), 0u);
}

TEST(ReadMie, TakesTheWavelengthFromTheMiddleOfEachBand) {
  const Case read = case_of(
      two_bands("{ model = \"mie\", radius = 300, index = 1.33, distribution = \"gamma\", variance = 0.1 }"));
  const auto& phases = read.media.at("air").phase;
  ASSERT_EQ(phases.size(), 2u);
  EXPECT_EQ(phases[0], PhaseFunction(mie_scattering(GammaSizes{300, 0.1}, 1.33, 650).phase));
  EXPECT_EQ(phases[1], PhaseFunction(mie_scattering(GammaSizes{300, 0.1}, 1.33, 500).phase));
}

TEST(ReadMie, IsAPartOfMixtures) {
  const Case read = case_of(
      two_bands("{ model = \"mixture\", mix = [{ weight = 1, model = \"rayleigh\" }, { weight = 3, model = "
                "\"mie\", radius = 100, index = 1.5 }] }"));
  const auto& mixture = std::get<PhaseMixture>(read.media.at("air").phase.at(1));
  EXPECT_EQ(mixture.shares[1], 0.75);
  EXPECT_EQ(mixture.parts[1], PhasePart(mie_scattering(OneSize{100}, 1.5, 500).phase));
}

TEST(ReadMie, SaysWhatIsMissingOrBelongsElsewhere) {
  const std::string faults = faults_of(one_band("{ model = \"mie\", deviation = 2 }"));
  EXPECT_NE(faults.find("media.air.phase.radius: missing; use "), std::string::npos) << faults;
  EXPECT_NE(faults.find("media.air.phase.index: missing; use "), std::string::npos) << faults;
  EXPECT_NE(faults.find("wavelength: missing; use a wavelength in the unit of radius, or bands.edges in nm"),
            std::string::npos)
      << faults;
  EXPECT_NE(faults.find("deviation = 2: unused (it belongs to a log-normal distribution)"), std::string::npos)
      << faults;
  EXPECT_NE(faults_of(one_band("{ model = \"mie\", radius = 1e6, index = 1.3, wavelength = 1 }"))
                .find("are too large (the series take too long)"),
            std::string::npos);
}

}  // namespace
}  // namespace etendue::read_mie_test
