// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "app/case/lamps/light_table.h"
#include "solver/observe/color/photometry.h"
#include "tests/app/case/case_text.h"

namespace etendue::lamp_files_test {
namespace {

using Numbers = std::vector<double>;

/// An EULUMDAT file of this symmetry with planes at these angles, angles of 0, 90 and 180 degrees, and
/// intensities 1, 2, 3 … of `stored` planes; two sets of lamps, the second of 5000 lm.
std::string ldt(int symmetry, const Numbers& planes, int stored, const std::string& first_intensity = "1",
                const std::string& lumens = "2000") {
  std::ostringstream text;
  text << "maker\n2\n"
       << symmetry << "\n"
       << planes.size() << "\n0\n3\n90\nreport\nlamp\nnumber\nfile\ndate\n";
  for (int i = 0; i < 9; ++i) text << "100\n";
  text << "50\n80\n1.0\n0\n2\n1\nLED\n" << lumens << "\n3000\n80\n20\n1\nLED\n5000\n3000\n80\n50\n";
  for (int i = 0; i < 10; ++i) text << "0,5\n";
  for (const double plane : planes) text << plane << "\n";
  text << "0\n90\n180\n" << first_intensity << "\n";
  for (int i = 2; i <= 3 * stored; ++i) text << " " << i << ".0\r\n";
  return text.str();
}

LightTable read(const std::string& text) {
  const TestFolder folder;
  return read_light_table(folder.write("lamp.LDT", text));
}

std::string refusal(const std::string& name, const std::string& text) {
  const TestFolder folder;
  try {
    read_light_table(folder.write(name, text));
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find(name));
  }
  return "";
}

TEST(LdtFile, HasItsCandelasOfTheFirstSetOfLamps) {
  const LightTable table = read(ldt(1, {0}, 1));
  EXPECT_TRUE(table.plane.empty());
  EXPECT_EQ(table.angle, (Numbers{0, 90, 180}));
  EXPECT_EQ(table.intensity, (Numbers{1, 2, 3}));
  EXPECT_EQ(table.candelas, 2.0);  // cd per 1000 lm
}

TEST(LdtFile, HasAShapeOnlyWithoutAFlux) {
  EXPECT_EQ(read(ldt(1, {0}, 1, "1", "0")).candelas, std::nullopt);
  const TestFolder folder;
  const std::string light =
      "[bands]\nnames = [\"a\"]\nedges = [450, 650]\n[[light]]\nname = \"a\"\nkind = \"point\"\n"
      "position = [0.5, 0.5, 0.9]\ndistribution = \"" +
      folder.write("lamp.ldt", ldt(1, {0}, 1, "1", "0")).string() + "\"\n";
  const Case input = case_of(cube + light + "luminous_flux = 500\n");
  EXPECT_NEAR(Photometry(input.bands).luminous(values_of(input.lights.at(0).strength)), 500, 1e-9);
  EXPECT_NE(faults_of(cube + light).find("needs power or luminous_flux"), std::string::npos);
  EXPECT_TRUE(refusal("a.ldt", ldt(1, {0}, 1, "1", "-1"))
                  .starts_with("a.ldt:29: the flux -1 of the lamps is negative"))
      << refusal("a.ldt", ldt(1, {0}, 1, "1", "-1"));
}

// Stored are all planes; C0 to C180; C270 over C0 to C90; C0 to C90.
TEST(LdtFile, AddsThePlanesOfSymmetricLamps) {
  const LightTable whole = read(ldt(0, {0, 120, 240}, 3));
  EXPECT_EQ(whole.plane, (Numbers{0, 120, 240, 360}));
  EXPECT_EQ(whole.intensity, (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 2, 3}));
  const LightTable sides = read(ldt(2, {0, 90, 180, 270}, 3));
  EXPECT_EQ(sides.plane, (Numbers{0, 90, 180, 270, 360}));
  EXPECT_EQ(sides.intensity, (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 4, 5, 6, 1, 2, 3}));
  const LightTable ends = read(ldt(3, {0, 90, 180, 270}, 3));
  EXPECT_EQ(ends.plane, (Numbers{-90, 0, 90, 180, 270}));
  EXPECT_EQ(ends.intensity, (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 4, 5, 6, 1, 2, 3}));
  const LightTable both = read(ldt(4, {0, 45, 90, 135, 180, 225, 270, 315}, 3));
  EXPECT_EQ(both.plane, (Numbers{0, 45, 90, 135, 180, 225, 270, 315, 360}));
  EXPECT_EQ(both.intensity,
            (Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 4, 5, 6, 1, 2, 3, 4, 5, 6, 7, 8, 9, 4, 5, 6, 1, 2, 3}));
}

TEST(LdtFile, IsRefusedByFileAndLine) {
  EXPECT_TRUE(refusal("a.ldt", ldt(5, {0}, 1))
                  .starts_with("a.ldt:3: 5 is no count, where the symmetry should stand"));
  EXPECT_TRUE(
      refusal("a.ldt", ldt(4, {0, 120, 240}, 1)).starts_with("a.ldt:4: 3 planes cannot have the symmetry 4"));
  EXPECT_TRUE(refusal("a.ldt", ldt(2, {0, 60, 120, 180}, 3))
                  .starts_with("a.ldt:52: planes of the symmetry 2 from 0 to 120"));
  EXPECT_TRUE(
      refusal("a.ldt", ldt(0, {0, 180, 90}, 3)).starts_with("a.ldt:51: 90 comes after 180 in the planes"));
  EXPECT_TRUE(refusal("a.ldt", ldt(1, {0}, 1, "l"))
                  .starts_with("a.ldt:53: \"l\" is not a number, where the intensities"));
  EXPECT_TRUE(refusal("a.ldt", ldt(1, {0}, 1, "-1")).starts_with("a.ldt:53: the intensity -1 is negative"));
  const std::string whole = ldt(1, {0}, 1);
  EXPECT_TRUE(refusal("a.ldt", whole.substr(0, whole.size() - 6))
                  .starts_with("a.ldt:54: ends before the intensities"));
}

const std::string header = "IESNA:LM-63-2002\n";
const std::string rest = "1 -1 1 2 1 1 2 0 0 0\n1 1 50\n0 180\n0\n100 100\n";

TEST(Tilt, OfTheFileAndOfOneBesideIt) {
  const TestFolder folder;
  const auto file = folder.write("lamp.ies", header + "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9\n0.7\n" + rest);
  const LightTable table = read_light_table(file);
  EXPECT_EQ(table.tilt.angle, (Numbers{0, 45, 90}));
  EXPECT_EQ(table.tilt.factor, (Numbers{1, 0.9, 0.7}));
  EXPECT_EQ(table.intensity, (Numbers{100, 100}));
  EXPECT_DOUBLE_EQ(*table.tilt.factor_at(60), 0.9 - 0.2 / 3);
  EXPECT_EQ(table.tilt.factor_at(90), 0.7);
  EXPECT_FALSE(table.tilt.factor_at(91));
  folder.write("factors.tlt", "3\n2\n0 180\n1 0.5\n");
  const auto other = folder.write("other.ies", header + "TILT=factors.tlt\n" + rest);
  EXPECT_EQ(read_light_table(other).tilt.factor, (Numbers{1, 0.5}));
}

TEST(Tilt, IsReadInLettersOfAnyCase) {
  const TestFolder folder;
  EXPECT_TRUE(read_light_table(folder.write("a.ies", header + "TILT=None\n" + rest)).tilt.angle.empty());
  const auto file = folder.write("b.ies", header + "Tilt=Include\n1\n2\n0 90\n1 0.5\n" + rest);
  EXPECT_EQ(read_light_table(file).tilt.factor, (Numbers{1, 0.5}));
}

TEST(Tilt, IsRefusedByFileAndLine) {
  EXPECT_TRUE(refusal("a.ies", header + "TILT=INCLUDE\n4\n")
                  .starts_with("a.ies:3: 4 is no lamp-to-luminaire geometry"));
  EXPECT_TRUE(refusal("a.ies", header + "TILT=INCLUDE\n1\n2\n0 0\n1 1\n" + rest)
                  .starts_with("a.ies:5: the tilt angle 0 comes after 0; they must rise"));
  EXPECT_TRUE(refusal("a.ies", header + "TILT=INCLUDE\n1\n2\n0 190\n1 1\n" + rest)
                  .starts_with("a.ies:5: tilt angles from 0 to 190"));
  EXPECT_TRUE(refusal("a.ies", header + "TILT=INCLUDE\n1\n2\n0 90\n1 -1\n" + rest)
                  .starts_with("a.ies:6: the tilt factor -1 is negative"));
  const std::string missing = refusal("a.ies", header + "TILT=none.tlt\n" + rest);
  EXPECT_TRUE(missing.starts_with("a.ies:2: the file ") &&
              missing.ends_with("none.tlt of TILT=none.tlt cannot be read"))
      << missing;
  EXPECT_TRUE(refusal("a.ies", header + "TILT=\n" + rest).starts_with("a.ies:2: \"TILT=\" says nothing"));
}

// A lamp of 100 cd that shines 60 degrees from straight down, where its factor is 0.8.
TEST(Tilt, DimsTheLampThatIsTilted) {
  const TestFolder folder;
  const auto file = folder.write("lamp.ies", header + "TILT=INCLUDE\n1\n2\n0 90\n1 0.7\n" + rest);
  const std::string lamp =
      "[bands]\nnames = [\"a\"]\nedges = [450, 650]\n[[light]]\nname = \"a\"\nkind = \"point\"\n"
      "position = [0.5, 0.5, 0.9]\ndistribution = \"" +
      file.string() + "\"\n";
  const auto lumens = [&](const std::string& direction) {
    const Case input = case_of(cube + lamp + "direction = " + direction + "\n");
    return Photometry(input.bands).luminous(values_of(input.lights.at(0).strength));
  };
  EXPECT_NEAR(lumens("[0, 0, -1]"), 4 * M_PI * 100, 1e-9);
  EXPECT_NEAR(lumens("[1.7320508075688772, 0, -1]"), 4 * M_PI * 80, 1e-9);
  EXPECT_EQ(case_of(cube + lamp + "direction = [1.7320508075688772, 0, -1]\n").lights.at(0).note,
            "TILT factor 0.8 at 60 degrees");
  EXPECT_NE(faults_of(cube + lamp + "direction = [0, 0, 1]\n")
                .find("is tilted by 180 degrees, and its TILT factors are from 0 to 90; turn the lamp"),
            std::string::npos);
}

// The factors of a lamp that lies across its luminaire are told to hold for all ways to turn it.
TEST(Tilt, SaysWhereTheLampLiesAcross) {
  const TestFolder folder;
  const auto note = [&](const std::string& geometry, const std::string& direction) {
    const auto file =
        folder.write("lamp.ies", header + "TILT=INCLUDE\n" + geometry + "\n2\n0 90\n1 0.7\n" + rest);
    return case_of(cube +
                   "[bands]\nnames = [\"a\"]\nedges = [450, 650]\n[[light]]\nname = \"a\"\nkind = \"point\"\n"
                   "position = [0.5, 0.5, 0.9]\ndistribution = \"" +
                   file.string() + "\"\ndirection = " + direction + "\n")
        .lights.at(0)
        .note;
  };
  const std::string across = "whichever way the lamp, which lies across its luminaire, is turned";
  for (const std::string geometry : {"2", "3"})
    EXPECT_TRUE(note(geometry, "[1, 0, -1]").ends_with(across)) << note(geometry, "[1, 0, -1]");
  EXPECT_EQ(note("2", "[0, 0, -1]"), "TILT factor 1 at 0 degrees");
  EXPECT_EQ(note("1", "[1, 0, -1]"), "TILT factor 0.85 at 45 degrees");
}

}  // namespace
}  // namespace etendue::lamp_files_test
