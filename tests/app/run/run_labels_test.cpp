// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/run/small_case.h"

namespace etendue::run_labels_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::text_of;
using test::write_text;

/// 6 x 6 x 5 voxels of 1 mm: two layers of skin (1) above fat (2), in which a vessel (3) runs along y.
int label(int i, int, int k) {
  if (k >= 3) return 1;
  return std::hypot(i - 2.5, k - 1.0) < 1.2 ? 3 : 2;
}

std::string image() {
  std::string text =
      R"(<?xml version="1.0"?><VTKFile type="ImageData" version="1.0">
<ImageData WholeExtent="0 6 0 6 0 5" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 6 0 6 0 5">
<CellData><DataArray type="Int16" Name="tissue" format="ascii">)";
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 6; ++i) text += std::to_string(label(i, j, k)) + " ";
  return text + "</DataArray></CellData></Piece></ImageData></VTKFile>\n";
}

const std::string tissue = R"(title = "A vessel under the skin"
[units]
length = "mm"
[mesh]
labels = { file = "head.vti", array = "tissue", regions = { skin = 1, fat = 2, vessel = 3 } }
[media.skin]
absorption = 0.05
scattering = 2
phase = { model = "henyey-greenstein", g = 0.8 }
[media.fat]
absorption = 0.01
scattering = 1
phase = { model = "henyey-greenstein", g = 0.8 }
[media.vessel]
absorption = 0.5
scattering = 1
phase = { model = "henyey-greenstein", g = 0.9 }
[walls.zmax]
radiance = 1
[walls."*"]
[directions]
order = 1
)";

/// The rows of regions.csv by region: volume, fluence_mean, absorbed, emitted.
std::map<std::string, std::vector<double>> regions_in(const std::filesystem::path& table) {
  std::istringstream lines(text_of(table));
  std::map<std::string, std::vector<double>> rows;
  std::string line, region, word;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::getline(words, region, ',');
    std::getline(words, word, ',');
    while (std::getline(words, word, ',')) rows[region].push_back(std::stod(word));
  }
  return rows;
}

TEST(RunLabels, MeshesTissueByItsVoxelsAndBalances) {
  const CaseFolder folder(tissue);
  write_text(folder.path() / "head.vti", image());
  const Outcome outcome = etendue_says({"run", folder.file(), "--output", folder.results()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  std::map<int, int> voxels;
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 6; ++i) ++voxels[label(i, j, k)];
  const auto regions = regions_in(folder.path() / "results/regions.csv");
  EXPECT_NEAR(regions.at("skin")[0], voxels[1], 1e-11);
  EXPECT_NEAR(regions.at("fat")[0], voxels[2], 1e-11);
  EXPECT_NEAR(regions.at("vessel")[0], voxels[3], 1e-11);
  EXPECT_GT(regions.at("vessel")[2], regions.at("fat")[2]);
  const json summary = json::parse(text_of(folder.path() / "results/summary.json"));
  for (const json& balance : summary["balance"]) EXPECT_LT(std::abs(balance["residual"].get<double>()), 1e-5);
}

std::string fault_of(const std::string& labels) {
  const CaseFolder folder("[mesh]\nlabels = " + labels + "\n" + tissue.substr(tissue.find("[media.skin]")));
  write_text(folder.path() / "head.vti", image());
  const Outcome outcome = etendue_says({"check", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  return outcome.err;
}

TEST(RunLabels, AreRefusedWithTheirPlace) {
  EXPECT_TRUE(has(fault_of(R"({ file = "head.vti", regions = { skin = 9 } })"),
                  "case.toml:2: mesh.labels.file: no voxel has the label 9 (region skin)"));
  EXPECT_TRUE(
      has(fault_of(R"({ file = "head.vti", array = "t", regions = { skin = 1 } })"), "holds no array \"t\""));
  EXPECT_TRUE(has(fault_of(R"({ file = "head.vti", regions = { skin = 1.5 } })"), "mesh.labels.regions"));
  EXPECT_TRUE(has(fault_of(R"({ file = "head.vti" })"), "mesh.labels.regions: missing"));
}

TEST(RunLabels, AreMeshedOnceWhereTheyNeedTooManyCells) {
  const CaseFolder folder(tissue);
  write_text(folder.path() / "head.vti", image());
  const Outcome outcome =
      etendue_says({"check", folder.file(), "--mesh", "--verbose", "--set", "mesh.max_cells=10"});
  EXPECT_EQ(outcome.code, ExitCode::input_error);
  EXPECT_TRUE(has(outcome.err, "needs more than 10 cells")) << outcome.err;
  EXPECT_FALSE(has(outcome.err, "again with a facet for each face of a voxel")) << outcome.err;
}

}  // namespace
}  // namespace etendue::run_labels_test
