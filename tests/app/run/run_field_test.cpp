// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "tests/app/run/small_case.h"

namespace etendue::run_field_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::text_of;
using test::write_text;

/// A VTK image of 8^3 voxels over the cube from -0.25 to 1.25, with a function at its points or in its
/// voxels.
std::string image(const std::string& data, const std::function<double(double, double, double)>& function) {
  constexpr int n = 8;
  constexpr double low = -0.25, step = 1.5 / n;
  const int count = data == "PointData" ? n + 1 : n;
  const double first = data == "PointData" ? low : low + step / 2;
  std::ostringstream text;
  text.precision(17);
  text << R"(<?xml version="1.0"?><VTKFile type="ImageData" version="1.0">)"
       << R"(<ImageData WholeExtent="0 8 0 8 0 8" Origin="-0.25 -0.25 -0.25" Spacing="0.1875 0.1875 0.1875">)"
       << R"(<Piece Extent="0 8 0 8 0 8"><)" << data
       << R"(><DataArray type="Float64" Name="kappa" format="ascii">)";
  for (int k = 0; k < count; ++k)
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i)
        text << function(first + i * step, first + j * step, first + k * step) << ' ';
  text << "</DataArray></" << data << "></Piece></ImageData></VTKFile>\n";
  return text.str();
}

double linear(double x, double y, double) { return 1 + 0.5 * x + 0.25 * y; }
double cloud(double x, double y, double z) {
  return 4 * std::exp(-6 * ((x - 0.4) * (x - 0.4) + (y - 0.5) * (y - 0.5) + (z - 0.6) * (z - 0.6)));
}

/// A unit cube of gas with these coefficients, and a warm floor.
std::string gas(const std::string& coefficients) {
  return R"([mesh]
edge_length = 0.35
[[mesh.box]]
region = "gas"
min = [0, 0, 0]
max = [1, 1, 1]
[bands]
names = ["red", "blue"]
[media.gas]
)" + coefficients +
         R"([walls.zmin]
radiance = 1
diffuse = 0.2
[walls."*"]
diffuse = 0.5
[directions]
order = 1
)";
}

std::vector<std::vector<double>> numbers_in(const std::filesystem::path& table) {
  std::istringstream lines(text_of(table));
  std::vector<std::vector<double>> rows;
  std::string line, word;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    rows.emplace_back();
    for (int column = 0; std::getline(words, word, ','); ++column)
      if (column >= 2) rows.back().push_back(std::stod(word));
  }
  return rows;
}

/// volume, fluence_mean, absorbed, emitted of the region for each band.
std::vector<std::vector<double>> regions_of(const CaseFolder& folder, const std::string& results,
                                            const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"run", folder.file(), "--output", (folder.path() / results).string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = etendue_says(arguments);
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err;
  return numbers_in(folder.path() / results / "regions.csv");
}

TEST(RunField, OfALinearFieldIsThatOfTheFormula) {
  const CaseFolder by_file(gas(R"(absorption = [{ file = "k.vti", array = "kappa" }, 0.5]
scattering = { file = "k.vti", scale = 2 }
emission = [0, { file = "k.vti", scale = 0.1, on = "points" }]
)"));
  write_text(by_file.path() / "k.vti", image("PointData", linear));
  const CaseFolder by_formula(gas(R"toml(absorption = ["1 + 0.5*x + 0.25*y", 0.5]
scattering = "2*(1 + 0.5*x + 0.25*y)"
emission = [0, "0.1*(1 + 0.5*x + 0.25*y)"]
)toml"));
  const auto file = regions_of(by_file, "results"), formula = regions_of(by_formula, "results");
  ASSERT_EQ(file.size(), 2U);
  for (std::size_t band = 0; band < 2; ++band)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(file[band][i], formula[band][i], 1e-9 * std::abs(formula[band][i])) << band << ' ' << i;
}

TEST(RunField, SaysRangeAndMeanAndRunsAgainFromItsOwnResults) {
  const CaseFolder folder(gas("absorption = { file = \"k.vti\" }\npower_density = [2, 3]\n"));
  write_text(folder.path() / "k.vti", image("PointData", linear));
  const Outcome outcome = etendue_says({"run", folder.file(), "--output", folder.results()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "absorption of gas: k.vti, from 1.")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, ", mean 1.375 1/m\n")) << outcome.out;
  // On the same mesh the cells' values are taken as they are: their integral is that of the first run.
  const auto first = numbers_in(folder.path() / "results/regions.csv");
  const auto second = regions_of(folder, "again",
                                 {"--set", "media.gas.power_density={file=\"" + folder.results() +
                                               "/fields.vtu\",array=\"fluence_mean\",component=1}"});
  for (const auto& band : second) EXPECT_NEAR(band[3], first[1][0] * first[1][1], 1e-9 * band[3]);
}

TEST(RunField, GoesOnFromASolutionWithTheSameNumbersInTheFileOnly) {
  const CaseFolder folder(gas("absorption = { file = \"k.vti\" }\n"));
  write_text(folder.path() / "k.vti", image("PointData", linear));
  regions_of(folder, "results");
  const std::vector<std::string> again = {
      "run",      folder.file(),
      "--output", (folder.path() / "again").string(),
      "--set",    "solve.initial=\"" + folder.results() + "/solution.vtu\""};
  EXPECT_EQ(etendue_says(again).code, ExitCode::done);
  write_text(folder.path() / "k.vti", image("PointData", cloud));
  const Outcome outcome = etendue_says(again);
  EXPECT_NE(outcome.code, ExitCode::done);
  EXPECT_TRUE(has(outcome.err, "is a solution of another case ([media] differ)")) << outcome.err;
}

TEST(RunField, OfVoxelsIsTheSameByPhotonsAndByOrdinates) {
  const CaseFolder folder(
      gas("extinction = { file = \"k.vti\" }\nalbedo = [0.5, 0.9]\n"
          "phase = { model = \"henyey-greenstein\", g = 0.5 }\n"));
  write_text(folder.path() / "k.vti", image("CellData", cloud));
  const auto ordinates = regions_of(folder, "ordinates", {"--set", "directions.order=2"});
  const auto photons =
      regions_of(folder, "photons", {"--set", "solve.method=\"photons\"", "--set", "solve.photons=100000"});
  for (std::size_t band = 0; band < 2; ++band)
    EXPECT_NEAR(ordinates[band][2], photons[band][2], 0.02 * photons[band][2]) << band;
}

std::string fault_of(const std::string& coefficients, const std::string& file) {
  const CaseFolder folder(gas(coefficients));
  write_text(folder.path() / "k.vti", file);
  const Outcome outcome = etendue_says({"check", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  return outcome.err;
}

TEST(RunField, IsRefusedWithThePlaceWhereItIsMissingOrNegative) {
  const std::string good = image("PointData", linear);
  EXPECT_TRUE(has(fault_of("absorption = { file = \"k.vti\", length_scale = 0.5 }\n", good),
                  "case.toml:10: media.gas.absorption: k.vti does not cover gas (not at ("));
  EXPECT_TRUE(has(fault_of("absorption = { file = \"k.vti\", scale = -1 }\n", good), ": negative at ("));
  EXPECT_TRUE(has(fault_of("absorption = { file = \"k.vti\", array = \"kapa\" }\n", good),
                  "case.toml:10: media.gas.absorption.file = \"k.vti\": holds no array \"kapa\""));
  EXPECT_TRUE(has(fault_of("absorption = { file = \"k.vti\" }\n", good.substr(0, good.size() / 2)),
                  "is it cut short or corrupt?"));
  EXPECT_TRUE(has(fault_of("absorption = { array = \"kappa\" }\n", good), "absorption.file: missing"));
  EXPECT_TRUE(has(fault_of("absorption = [{ file = \"k.vti\" }, \"k\"]\n", good), "is not a formula"));
  EXPECT_TRUE(has(fault_of("power = { file = \"k.vti\" }\n", good), "must not be a table"));
  const std::string lost = image("CellData", [](double x, double, double) { return x > 0.5 ? NAN : 1; });
  EXPECT_TRUE(has(fault_of("absorption = { file = \"k.vti\" }\n", lost), "not a finite number at ("))
      << fault_of("absorption = { file = \"k.vti\" }\n", lost);
}

TEST(RunField, GivesARadianceOfWallsAndAValueOutside) {
  const CaseFolder by_file(gas("absorption = { file = \"k.vti\", length_scale = 0.1, outside = 0.5 }\n"));
  write_text(by_file.path() / "k.vti", image("PointData", linear));
  const Outcome outcome =
      etendue_says({"run", by_file.file(), "--output", by_file.results(), "--set",
                    "walls.zmin.radiance={file=\"" + (by_file.path() / "k.vti").string() + "\"}"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  const CaseFolder by_formula(gas("absorption = { file = \"k.vti\", length_scale = 0.1, outside = 0.5 }\n"));
  write_text(by_formula.path() / "k.vti", image("PointData", linear));
  const auto formula =
      regions_of(by_formula, "results", {"--set", "walls.zmin.radiance=\"1 + 0.5*x + 0.25*y\""});
  const auto file = numbers_in(by_file.path() / "results/regions.csv");
  for (std::size_t band = 0; band < 2; ++band)
    EXPECT_NEAR(file[band][2], formula[band][2], 1e-9 * formula[band][2]);
}

}  // namespace
}  // namespace etendue::run_field_test
