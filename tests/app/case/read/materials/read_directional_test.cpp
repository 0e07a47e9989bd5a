// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Leaves, flakes, kernels, and formulas that use the direction of travel.
#include <gtest/gtest.h>

#include "tests/app/case/case_text.h"

namespace etendue::read_directional_test {
namespace {

const std::string air = cube + "[media.air]\n";  // the next line is 8

MediumCase medium_of(const std::string& text) { return case_of(air + text).media.at("air"); }

std::string faults(const std::string& text) { return faults_of(air + text); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

double number(const std::optional<BandValues>& values, std::size_t band) {
  return std::get<double>(values->values.at(band));
}

TEST(LeavesReader, ReadsACanopyWithMeansOverAllDirections) {
  const MediumCase medium = medium_of(
      "[media.air.leaves]\narea_density = 2\nangles = \"planophile\"\nreflectance = [0.1, 0.4]\n"
      "transmittance = [0.05, 0.4]\n[bands]\nnames = [\"red\", \"infrared\"]\n");
  ASSERT_EQ(medium.directional.size(), 2u);
  EXPECT_EQ(std::get<LeafCanopy>(medium.directional[1]), (LeafCanopy{LeafAngles::planophile, 0.4, 0.4}));
  // A leaf is seen with half its area in the mean.
  EXPECT_NEAR(number(medium.absorption, 0), 2 * 0.5 * 0.85, 1e-15);
  EXPECT_NEAR(number(medium.scattering, 1), 2 * 0.5 * 0.8, 1e-15);
}

TEST(LeavesReader, ReadsADensityByFormula) {
  const MediumCase medium = medium_of("[media.air.leaves]\narea_density = \"1 + z\"\nreflectance = 0.5\n");
  EXPECT_EQ(std::get<Formula>(medium.scattering->values[0]).text, "(1 + z)*0.25");
}

TEST(LeavesReader, RefusesWhatMakesNoSense) {
  EXPECT_TRUE(has(faults("[media.air.leaves]\narea_density = 1\nreflectance = 0.7\ntransmittance = 0.5\n"),
                  "media.air.leaves: reflectance + transmittance = 1.2 (a leaf would make light)"));
  EXPECT_TRUE(has(faults("[media.air.leaves]\nreflectance = 0.7\n"), "area_density"));
  EXPECT_TRUE(has(faults("[media.air.leaves]\narea_density = 1\nangles = \"sperical\"\n"),
                  "did you mean \"spherical\"?"));
  EXPECT_TRUE(has(faults("absorption = 1\n[media.air.leaves]\narea_density = 1\n"),
                  "slab.toml:8: media.air.absorption = 1: "));
  EXPECT_TRUE(has(faults("[media.air.leaves]\narea_density = 1\n[media.air.flakes]\ndensity = 1\n"),
                  "use one of them"));
  EXPECT_TRUE(has(faults("[media.air.leaves]\narea_density = 1\n[directions]\nset = \"flatland\"\n"
                         "order = 8\n"),
                  "use another direction set than flatland"));
}

TEST(FlakesReader, ReadsAnEllipsoid) {
  const MediumCase medium =
      medium_of("[media.air.flakes]\ndensity = 3\naxis = [0, 0, 2]\nalong = 1\nacross = 0.2\nalbedo = 0.5\n");
  const MicroFlakes flakes = std::get<MicroFlakes>(medium.directional[0]);
  EXPECT_EQ(flakes, (MicroFlakes{Vec3::UnitZ(), 1, 0.2, 0.5}));
  EXPECT_NEAR(number(medium.absorption, 0), number(medium.scattering, 0), 1e-14);
  EXPECT_TRUE(has(faults("[media.air.flakes]\ndensity = 3\naxis = [0, 0, 0]\n"), "has no direction"));
  EXPECT_TRUE(has(faults("[media.air.flakes]\ndensity = 3\nalong = 0\n"), "media.air.flakes.along = 0"));
  EXPECT_TRUE(has(faults("[media.air.flakes]\nalong = 1\n"), "density"));
}

TEST(KernelReader, ReadsAFormulaWithAbsorptionOrExtinction) {
  const MediumCase medium = medium_of("kernel = \"0.1*(1 + wx*vx)\"\nreciprocal = true\nabsorption = 0.2\n");
  const KernelFormula kernel = std::get<KernelFormula>(medium.directional[0]);
  EXPECT_TRUE(kernel.reciprocal);
  EXPECT_NEAR(kernel.at(Vec3(1, 0, 0), Vec3(0.6, 0.8, 0)), 0.16, 1e-15);
  EXPECT_EQ(number(medium.absorption, 0), 0.2);
  EXPECT_TRUE(medium.has_kernel);
  EXPECT_EQ(
      *std::get<KernelFormula>(medium_of("kernel = \"0.1\"\nextinction = 2\n").directional[0]).extinction, 2);
  const MediumCase by_direction = medium_of("kernel = \"0.1\"\nextinction = \"2 + wz\"\n");
  EXPECT_EQ(std::get<Formula>(by_direction.kernel_extinction.values[0]).text, "2 + wz");
}

TEST(KernelReader, RefusesFormulasThatAreNone) {
  EXPECT_TRUE(
      has(faults("kernel = \"0.1*ux\"\n"), "slab.toml:8: media.air.kernel = \"0.1*ux\": is not a formula"));
  EXPECT_TRUE(has(faults("kernel = 0.1\n"), "is no kernel; use a formula or { file = \"k.csv\" }"));
  EXPECT_TRUE(has(faults("kernel = { path = \"k.csv\" }\n"), "is no kernel"));
  EXPECT_TRUE(has(faults("kernel = \"0.1\"\nscattering = 1\n"), "slab.toml:9: media.air.scattering = 1: "));
  EXPECT_TRUE(has(faults("kernel = \"0.1\"\nextinction = 1\nabsorption = 1\n"),
                  "extinction says what the kernel does not scatter"));
  EXPECT_TRUE(has(faults("reciprocal = true\n"), "there is no kernel"));
}

/// A case with a kernel's file beside it: the matrix, or what is wrong.
struct Beside {
  KernelMatrix matrix;
  std::string faults;
};
Beside kernel_beside(const std::string& content) {
  const TestFolder folder;
  folder.write("k.csv", content);
  const auto file = folder.write("slab.toml", air + "kernel = { file = \"k.csv\" }\nabsorption = 1\n");
  try {
    return {std::get<KernelMatrix>(read_case(file).media.at("air").directional[0]), ""};
  } catch (const InputError& error) {
    return {{}, error.what()};
  }
}

TEST(KernelReader, ReadsAFileOfPairs) {
  const Beside read = kernel_beside("from, into, k\n0, 1, 0.5\n2, 0, 0.25  # back\n");
  EXPECT_EQ(read.faults, "");
  EXPECT_EQ(read.matrix.count, 3);
  EXPECT_EQ(read.matrix.values, (std::vector<double>{0, 0.5, 0, 0, 0, 0, 0.25, 0, 0}));
}

TEST(KernelReader, NamesTheLineOfAFaultyFile) {
  EXPECT_TRUE(has(kernel_beside("0, 1, 0.5\n1, 2\n").faults, "k.csv:2: 2 values on this line; use 3"));
  EXPECT_TRUE(has(kernel_beside("0, 1, much\n").faults, "k.csv:1: k = much: is not a number"));
  EXPECT_TRUE(has(kernel_beside("0.5, 1, 1\n").faults, "its file names the ordinate 0.5; use whole numbers"));
  EXPECT_TRUE(has(kernel_beside("-1, 1, 1\n").faults, "its file names the ordinate -1"));
}

TEST(KernelReader, RefusesOrdinatesThatThereAreNotAndPairsGivenTwice) {
  // A matrix for 100000 directions would take 80 GB.
  EXPECT_TRUE(has(kernel_beside("0, 99999, 1\n").faults,
                  "slab.toml:8: media.air.kernel: its file names the ordinate 99999; use whole numbers "
                  "from 0 to 95"));
  EXPECT_TRUE(has(kernel_beside("0, 1, 0.5\n1, 0, 0.5\n0, 1, 0.25\n").faults,
                  "its file has two values from 0 into 1; use one"));
}

TEST(KernelReader, SaysThatTheFileIsMissing) {
  EXPECT_THROW(case_of(air + "kernel = { file = \"none.csv\" }\n"), std::exception);
}

TEST(DirectionFormulas, AreReadWhereTheyMayBe) {
  const MediumCase medium =
      medium_of("absorption = \"1 + 0.5*wz\"\nscattering = 1\nemission = \"max(0, wx)*y\"\n");
  EXPECT_EQ(std::get<Formula>(medium.absorption->values[0]).text, "1 + 0.5*wz");
  EXPECT_EQ(std::get<Formula>(medium.emission->values[0]).text, "max(0, wx)*y");
  EXPECT_EQ(faults("extinction = \"2 + wz\"\nscattering = 1\n"), "");
}

TEST(DirectionFormulas, AreRefusedWhereScatteringWouldFollowFromThem) {
  EXPECT_TRUE(
      has(faults("extinction = \"2 + wz\"\nalbedo = 0.5\n"), "scattering would depend on the direction"));
  EXPECT_TRUE(
      has(faults("extinction = 3\nabsorption = \"1 + wz\"\n"), "scattering would depend on the direction"));
  EXPECT_TRUE(
      has(faults("absorption = \"1 + wz\"\nscattering = 1\nscattering_method = \"moments\"\n"),
          "slab.toml:10: media.air.scattering_method = \"moments\": not where absorption depends on"));
  EXPECT_TRUE(
      has(faults("emission = \"1 + wz\"\nuncollided = true\n"),
          "slab.toml:9: media.air.uncollided = true: not for emission that depends on the direction"));
}

}  // namespace
}  // namespace etendue::read_directional_test
