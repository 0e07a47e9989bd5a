// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "solver/materials/surfaces/microfacets.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/materials/surfaces/reflectance_table.h"
#include "solver/materials/surfaces/ward.h"
#include "tests/app/case/case_text.h"

namespace etendue::read_glossy_test {
namespace {

const std::string two_bands = cube + "[bands]\nnames = [\"a\", \"b\"]\n";  // lines 7 and 8
const std::string glossy = "[walls.zmin.glossy]\n";

WallCase floor_of(const std::string& text) { return case_of(text).walls.at("zmin"); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A floor by a table that stands beside the case, and what is wrong with it.
struct Beside {
  WallCase floor;
  std::string faults;
};
Beside table_beside(const std::string& content) {
  const TestFolder folder;
  folder.write("wood.csv", content);
  const std::filesystem::path file = folder.write(
      "slab.toml", cube + glossy + "model = \"table\"\nfile = \"wood.csv\"\nreflectance = 0.5\n");
  try {
    return {read_case(file).walls.at("zmin"), ""};
  } catch (const InputError& error) {
    return {{}, error.what()};
  }
}

TEST(GlossyReader, ReadsTheModels) {
  const WallCase phong =
      floor_of(two_bands + glossy + "model = \"phong\"\nexponent = 30\nreflectance = [0.5, 0.25]\n");
  ASSERT_EQ(phong.glossy.size(), 2U);
  EXPECT_EQ(phong.glossy[0]->value(0.7, 0.6, 0.1), Phong(0.5, 30).value(0.7, 0.6, 0.1));
  EXPECT_EQ(phong.glossy[1]->value(0.7, 0.6, 0.1), Phong(0.25, 30).value(0.7, 0.6, 0.1));
  const WallCase ggx = floor_of(two_bands + glossy +
                                "model = \"ggx\"\nroughness = 0.2\nreflectance = 0.04\nfresnel = "
                                "\"schlick\"\n");
  EXPECT_EQ(ggx.glossy[0]->value(0.7, 0.6, 0.1),
            Microfacets(0.04, 0.2, FacetFresnel::schlick).value(0.7, 0.6, 0.1));
  EXPECT_EQ(ggx.glossy[0], ggx.glossy[1]);
  const WallCase ward =
      floor_of(two_bands + glossy + "model = \"ward\"\nroughness = 0.2\nreflectance = [0.04, 0.3]\n");
  EXPECT_EQ(ward.glossy[1]->value(0.7, 0.6, 0.1), Ward(0.3, 0.2).value(0.7, 0.6, 0.1));
}

TEST(GlossyReader, ABandWithoutReflectanceHasNoLobe) {
  const WallCase floor =
      floor_of(two_bands + glossy + "model = \"phong\"\nexponent = 30\nreflectance = [0.5, 0]\n");
  EXPECT_NE(floor.glossy[0], nullptr);
  EXPECT_EQ(floor.glossy[1], nullptr);
}

TEST(GlossyReader, ReadsATableBesideTheCase) {
  const Beside even = table_beside("angle_in, angle_out, azimuth, value\n0,0,0,0.3\n");
  ASSERT_EQ(even.faults, "");
  EXPECT_NEAR(even.floor.glossy[0]->value(0.7, 0.6, 0.1), 0.15, 1e-15);
}

TEST(GlossyReader, TellsWhatIsWrong) {
  EXPECT_EQ(faults_of(cube + glossy + "model = \"phong\"\n"),
            "slab.toml:7: walls.zmin.glossy.exponent: missing; use a number from 0 to 100000");
  EXPECT_EQ(faults_of(cube + glossy + "model = \"ggx\"\nroughness = 0.2\nexponent = 3\n"),
            "slab.toml:10: walls.zmin.glossy.exponent = 3: unused (it belongs to model = \"phong\"); "
            "remove it");
  EXPECT_EQ(faults_of(cube + glossy + "model = \"ward\"\n"),
            "slab.toml:7: walls.zmin.glossy.roughness: missing; use a number from 0.001 to 1");
  EXPECT_EQ(faults_of(cube + glossy + "model = \"ward\"\nroughness = 0.2\nfresnel = \"schlick\"\n"),
            "slab.toml:10: walls.zmin.glossy.fresnel = \"schlick\": unused (it belongs to model = \"ggx\"); "
            "remove it");
  EXPECT_EQ(faults_of(cube + glossy + "model = \"phong\"\nexponent = 3\nroughness = 0.2\n"),
            "slab.toml:10: walls.zmin.glossy.roughness = 0.2: unused (it belongs to model = \"ggx\" or "
            "\"ward\"); remove it");
  EXPECT_TRUE(
      has(table_beside("0,0,0,0.1\n0,60,0,0.1\n60,0,0,0.3\n60,60,0,0.1\n").faults,
          "walls.zmin.glossy.file = \"wood.csv\": not reciprocal: 0.3 at in = 60, out = 0, azimuth = 0 "
          "degrees and 0.1 the other way"));
  EXPECT_TRUE(has(table_beside("0,0,0\n").faults,
                  "wood.csv:1: 3 values on this line; use 4 (angle_in, angle_out, azimuth, value)"));
}

// Schlick's facets reflect all light that grazes them: nothing is left for the diffuse part.
TEST(GlossyReader, RefusesMoreThanArrives) {
  EXPECT_TRUE(
      has(faults_of(cube + "[walls.zmin]\ndiffuse = 0.3\n" + glossy +
                    "model = \"phong\"\nexponent = 10\nreflectance = 0.8\n"),
          "slab.toml:7: walls.zmin: glossy reflects 0.8 of light at 0 degrees to the normal, and "
          "diffuse + specular + transmittance = 0.3 (more light would leave than arrives); use at most "
          "1 together"));
  EXPECT_TRUE(has(faults_of(cube + "[walls.zmin]\ndiffuse = 0.5\n" + glossy +
                            "model = \"ggx\"\nroughness = 0.01\nreflectance = 0.04\nfresnel = \"schlick\"\n"),
                  "slab.toml:7: walls.zmin: glossy reflects"));
  EXPECT_EQ(faults_of(cube + "[walls.zmin]\ndiffuse = 0.4\nspecular = 0.2\ntransmittance = 0.5\n"),
            "slab.toml:7: walls.zmin: diffuse + specular + transmittance = 1.1 (more light would leave than "
            "arrives); use at most 1");
}

}  // namespace
}  // namespace etendue::read_glossy_test
