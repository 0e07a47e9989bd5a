// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/study/study_trust.h"
#include "tests/app/run/small_case.h"
#include "tests/app/study/exact_case.h"

namespace etendue::study_test {
namespace {

using nlohmann::json;
using test::CaseFolder;
using test::etendue_says;
using test::exact_case;
using test::has;
using test::Outcome;
using test::rows_of;
using test::study_in;
using test::study_of;
using test::text_of;

LevelResult level_with(int level, int cells, std::vector<StudyValue> values) {
  LevelResult result;
  result.level = level;
  result.converged = true;
  result.cells = cells;
  result.size = std::cbrt(1.0 / cells);
  result.directions = 8 * level * level;
  result.values = std::move(values);
  return result;
}

TEST(StudyRows, HaveOrdersAgainstTheExactValueFromTheSecondLevelOn) {
  const std::vector<LevelResult> levels = {level_with(1, 10, {{"grey", "probe:a:0", 1.4, 1.0}}),
                                           level_with(2, 80, {{"grey", "probe:a:0", 0.9, 1.0}})};
  const auto rows = study_rows(levels, Refinement::mesh);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(*rows[0].error, 0.4, 1e-15);
  EXPECT_FALSE(rows[0].order);
  EXPECT_NEAR(*rows[1].order, 2, 1e-12);
}

TEST(StudyRows, CompareWithTheFinestLevelWhereNothingIsExact) {
  std::vector<LevelResult> levels;
  for (int level = 1; level <= 3; ++level)
    levels.push_back(level_with(level, 10, {{"grey", "probe:a:0", std::pow(2.0, -level), {}}}));
  const auto rows = study_rows(levels, Refinement::directions);
  EXPECT_DOUBLE_EQ(*rows[0].error, 0.375);
  EXPECT_DOUBLE_EQ(*rows[1].error, 0.125);
  EXPECT_NEAR(*rows[1].order, std::log(3.0) / std::log(2.0), 1e-12);
  EXPECT_FALSE(rows[2].error);
  EXPECT_FALSE(rows[2].order);
}

TEST(StudyRows, ClaimNoOrderOfABalance) {
  const std::vector<LevelResult> levels = {level_with(1, 10, {{"grey", "balance", 1e-8, 0.0}}),
                                           level_with(2, 80, {{"grey", "balance", -1e-9, 0.0}})};
  const auto rows = study_rows(levels, Refinement::mesh);
  EXPECT_DOUBLE_EQ(*rows[1].error, 1e-9);
  EXPECT_FALSE(rows[1].order);
}

TEST(StudyRows, ClaimNoOrderWhereTheIterationIsSeen) {
  std::vector<LevelResult> levels = {level_with(1, 10, {{"grey", "probe:a:0", 1.4, 1.0}}),
                                     level_with(2, 80, {{"grey", "probe:a:0", 0.9, 1.0}})};
  levels[1].residual = 0.1;  // of 0.9: just below a tenth of the error 0.1 would be 0.0111
  const auto seen = study_rows(levels, Refinement::mesh);
  EXPECT_DOUBLE_EQ(*seen[1].iteration, 0.09);
  EXPECT_FALSE(seen[1].order);
  EXPECT_TRUE(
      has(study_text(seen, levels, Refinement::mesh), "level 2: the iteration errs by about 9.0e-02"));
  levels[1].residual = 0.011;
  const auto hidden = study_rows(levels, Refinement::mesh);
  EXPECT_NEAR(*hidden[1].order, 2, 1e-12);
  EXPECT_FALSE(has(study_text(hidden, levels, Refinement::mesh), "the iteration errs"));
}

TEST(StudyRows, MayBeTakenAgainstTheLimitOfTheLastThree) {
  std::vector<LevelResult> levels;
  for (int level = 1; level <= 4; ++level) {
    const int cells = 10 << (3 * level);
    levels.push_back(level_with(level, cells,
                                {{"grey", "probe:a:0", 2 + std::pow(cells, -2.0 / 3), {}},
                                 {"grey", "wall:a:incoming", std::pow(-1.0, level), {}}}));
  }
  const auto rows = study_rows(levels, Refinement::mesh, StudyReference::richardson);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(rows[i].reference, ErrorReference::richardson);
    EXPECT_NEAR(*rows[i].error, std::pow(levels[i].cells, -2.0 / 3), 1e-9);
  }
  EXPECT_NEAR(*rows[1].order, 2, 1e-3);
  EXPECT_FALSE(rows[2].order) << "the limit's own";
  EXPECT_FALSE(rows[3].order);
  EXPECT_EQ(rows[4].reference, ErrorReference::finest) << "what goes to and fro has no limit";
  EXPECT_FALSE(rows[7].error);
}

// The last level of a grid that is there may have the coarsest directions of all.
TEST(StudyRows, HaveNoErrorsInAGridWithoutItsFinestLevel) {
  std::vector<LevelResult> levels;
  for (int level = 1; level <= 4; ++level) {
    levels.push_back(level_with(level, level < 3 ? 10 : 80, {{"grey", "probe:a:0", 1.0 * level, {}}}));
    levels.back().directions = level % 2 == 1 ? 8 : 32;
  }
  EXPECT_DOUBLE_EQ(*study_rows(levels, Refinement::both)[2].error, 1);
  levels.pop_back();
  EXPECT_EQ(finest_of(levels), nullptr);
  for (const StudyRow& row : study_rows(levels, Refinement::both)) EXPECT_FALSE(row.error);
}

TEST(StudyRows, SkipLevelsThatAreMissing) {
  const std::vector<LevelResult> levels = {level_with(1, 10, {{"grey", "probe:a:0", 1.4, 1.0}}),
                                           level_with(3, 640, {{"grey", "probe:a:0", 1.025, 1.0}})};
  EXPECT_NEAR(*study_rows(levels, Refinement::mesh)[1].order, 2, 1e-12);
}

TEST(StudyCsv, HasTheColumnsOfTheContract) {
  std::vector<LevelResult> levels = {level_with(1, 8, {{"grey", "wall:a, b:incoming", 0.5, {}}})};
  levels[0].size = 0.5;  // the library's cube root of 1/8 is off by a bit unless the compiler takes it
  EXPECT_EQ(study_csv(study_rows(levels, Refinement::mesh), Refinement::mesh),
            "level,refined,cells,h,directions,band,quantity,value,error,order,sweeps,seconds\n"
            "1,mesh,8,0.5,8,grey,\"wall:a, b:incoming\",0.5,,,0,0\n");
}

TEST(Study, RefinesTheMeshAndComparesWithTheExactSolution) {
  const CaseFolder folder(exact_case());
  const Outcome outcome = etendue_says(study_of(folder.file(), "mesh", 2));
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "fluence_L2")) << outcome.out;
  const json study = study_in(folder);
  const std::vector<json> norms = rows_of(study, "fluence_L2");
  ASSERT_EQ(norms.size(), 2U);
  EXPECT_GT(norms[1]["cells"], 3 * norms[0]["cells"].get<int>());
  EXPECT_EQ(norms[0]["directions"], norms[1]["directions"]);
  EXPECT_LT(norms[1]["error"], 0.01);
  EXPECT_GT(norms[1]["order"], 1.5);
  for (const char* quantity : {"probe:middle:0", "wall:xmin:incoming", "region:medium:absorbed"}) {
    const std::vector<json> rows = rows_of(study, quantity);
    ASSERT_EQ(rows.size(), 2U) << quantity;
    EXPECT_LT(rows[1]["error"], 0.01 * rows[1]["value"].get<double>()) << quantity;
    EXPECT_EQ(rows[1]["reference"], "exact") << quantity;
  }
  EXPECT_LT(rows_of(study, "balance")[1]["error"], 1e-6);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "results/level-2/fields.vtu"));
}

TEST(Study, DoublesTheOrderOfTheDirections) {
  const CaseFolder folder(exact_case());
  ASSERT_EQ(etendue_says(study_of(folder.file(), "directions", 2)).code, ExitCode::done);
  const std::vector<json> norms = rows_of(study_in(folder), "fluence_L2");
  ASSERT_EQ(norms.size(), 2U);
  EXPECT_EQ(norms[0]["directions"], 8);
  EXPECT_EQ(norms[1]["directions"], 32);
  EXPECT_EQ(norms[0]["cells"], norms[1]["cells"]);
  EXPECT_EQ(rows_of(study_in(folder), "wall:xmin:incoming")[0]["reference"], "finest");
}

TEST(Study, TakesTheFinestLevelWithoutAnExactSolution) {
  const CaseFolder folder;
  ASSERT_EQ(etendue_says(study_of(folder.file(), "mesh", 2)).code, ExitCode::done);
  const json study = study_in(folder);
  const std::vector<json> norms = rows_of(study, "fluence_L2");
  ASSERT_EQ(norms.size(), 6U);  // three bands
  EXPECT_EQ(norms[0]["reference"], "finest");
  EXPECT_GT(norms[0]["error"], 1e-4);
  EXPECT_LT(norms[0]["error"], 1);
  EXPECT_LT(norms[0]["error"], rows_of(study, "fluence_Linf")[0]["error"]);
  EXPECT_TRUE(norms[1]["error"].is_null());
  const std::vector<json> rows = rows_of(study, "probe:middle:0");
  ASSERT_EQ(rows.size(), 6U);  // three bands
  EXPECT_EQ(rows[0]["reference"], "finest");
  EXPECT_NEAR(rows[0]["error"], std::abs(rows[0]["value"].get<double>() - rows[1]["value"].get<double>()),
              1e-15);
  EXPECT_TRUE(rows[1]["error"].is_null());
}

TEST(Study, ResumesWithTheLevelsThatTheSameCaseMade) {
  const CaseFolder folder(exact_case());
  std::vector<std::string> arguments = study_of(folder.file(), "mesh", 2);
  ASSERT_EQ(etendue_says(arguments).code, ExitCode::done);
  const json first = study_in(folder);
  arguments.push_back("--resume");
  const Outcome same = etendue_says(arguments);
  EXPECT_TRUE(has(same.out, "level 1 of 2: kept")) << same.out;
  EXPECT_TRUE(has(same.out, "level 2 of 2: kept")) << same.out;
  EXPECT_EQ(study_in(folder), first);
  std::filesystem::remove(folder.path() / "results/level-2/walls.vtp");
  const Outcome incomplete = etendue_says(arguments);
  EXPECT_TRUE(has(incomplete.out, "level 1 of 2: kept"));
  EXPECT_FALSE(has(incomplete.out, "level 2 of 2: kept"));
  arguments.insert(arguments.end(), {"--set", "solve.tolerance=1e-7"});
  EXPECT_FALSE(has(etendue_says(arguments).out, "kept"));
}

TEST(Study, CutsTheCellsOfTheFirstMeshWhereItIsNested) {
  const CaseFolder folder(exact_case());
  std::vector<std::string> arguments = study_of(folder.file(), "mesh", 3);
  arguments.push_back("--nested");
  ASSERT_EQ(etendue_says(arguments).code, ExitCode::done);
  const std::vector<json> norms = rows_of(study_in(folder), "fluence_L2");
  ASSERT_EQ(norms.size(), 3U);
  for (std::size_t level = 1; level < 3; ++level) {
    EXPECT_EQ(norms[level]["cells"], 8 * norms[level - 1]["cells"].get<int>());
    EXPECT_NEAR(norms[level]["h"], norms[level - 1]["h"].get<double>() / 2, 1e-12);
  }
  EXPECT_GT(norms[2]["order"], 1.9);
}

TEST(Study, SaysWhatIsKnownOfAFamily) {
  std::string text = exact_case();
  const std::string formula = "radiance = \"3 + sin(2*x)*wx + cos(y + z)*wy^2\"";
  text.replace(text.find(formula), formula.size(), "family = \"kink\"");
  const CaseFolder folder(text);
  const Outcome outcome = etendue_says(study_of(folder.file(), "mesh", 3));
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "exact.family = \"kink\": the best approximation has order 1.5 of fluence_L2"))
      << outcome.out;
  EXPECT_EQ(study_in(folder)["expected_order"], 1.5);
  EXPECT_GT(rows_of(study_in(folder), "fluence_L2")[2]["order"], 1.5);
  const Outcome directions = etendue_says(study_of(folder.file(), "directions", 2));
  EXPECT_TRUE(has(directions.out, "no set of directions is exact for it")) << directions.out;
}

TEST(Study, DrawsItsErrors) {
  const CaseFolder folder(exact_case());
  std::vector<std::string> arguments = study_of(folder.file(), "mesh", 2);
  std::erase(arguments, "--no-plot");
  const Outcome outcome = etendue_says(arguments);
  EXPECT_TRUE(has(outcome.out, "study.csv study.json study.svg")) << outcome.out;
  const std::string picture = text_of(folder.path() / "results/study.svg");
  EXPECT_TRUE(has(picture, "<svg")) << picture.substr(0, 200);
  EXPECT_TRUE(has(picture, "line2d")) << "nothing is drawn";
}

TEST(Study, KeepsTheOtherLevelsWhereOneFails) {
  const CaseFolder folder(exact_case());
  std::filesystem::create_directories(folder.path() / "results");
  test::write_text(folder.path() / "results/level-1", "in the way");
  const Outcome outcome = etendue_says(study_of(folder.file(), "mesh", 2));
  EXPECT_EQ(outcome.code, ExitCode::not_converged);
  EXPECT_TRUE(has(outcome.err, "level 1 of 2 failed: ")) << outcome.err;
  const std::vector<json> norms = rows_of(study_in(folder), "fluence_L2");
  ASSERT_EQ(norms.size(), 1U);
  EXPECT_EQ(norms[0]["level"], 2);
  EXPECT_TRUE(has(outcome.out, "level 1 failed and is left out: ")) << outcome.out;
  EXPECT_EQ(study_in(folder)["failed"][0]["level"], 1);
}

TEST(Study, GoesOnWithoutLevelsThatAreRefused) {
  std::string text = exact_case();
  const std::string set = "set = \"product\"\norder = 2";
  text.replace(text.find(set), set.size(), "set = \"level-symmetric\"\norder = 16");
  const CaseFolder folder(text);
  const Outcome outcome = etendue_says(study_of(folder.file(), "directions", 2));
  EXPECT_EQ(outcome.code, ExitCode::not_converged);
  EXPECT_TRUE(has(outcome.err, "level 2 of 2 failed: ")) << outcome.err;
  EXPECT_EQ(rows_of(study_in(folder), "fluence_L2").size(), 1U);
  EXPECT_EQ(study_in(folder)["failed"][0]["level"], 2);
}

TEST(Study, SaysWhatCannotBeRefined) {
  std::string text = test::small_case();
  text.erase(text.find("max_volume"), std::string("max_volume = 0.02\n").size());
  const CaseFolder folder(text);
  const Outcome mesh = etendue_says(study_of(folder.file(), "mesh", 2));
  EXPECT_EQ(mesh.code, ExitCode::input_error);
  EXPECT_TRUE(has(mesh.err, "no cell size to refine")) << mesh.err;
}

TEST(Study, OfBothShowsTheErrorsOnAGridAndClaimsNoOrder) {
  const CaseFolder folder(exact_case());
  const Outcome outcome = etendue_says(study_of(folder.file(), "both", 2));
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "study: 1 of 4 levels, about ")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "error of fluence_L2, band grey, against the exact value")) << outcome.out;
  const std::vector<json> norms = rows_of(study_in(folder), "fluence_L2");
  ASSERT_EQ(norms.size(), 4U);
  EXPECT_EQ(norms[0]["cells"], norms[1]["cells"]);
  EXPECT_LT(norms[0]["directions"], norms[1]["directions"]);
  EXPECT_LT(norms[1]["cells"], norms[2]["cells"]);
  EXPECT_EQ(norms[1]["directions"], norms[3]["directions"]);
  const json study = study_in(folder);
  for (const json& row : study["rows"]) EXPECT_TRUE(row["order"].is_null());
  EXPECT_LT(norms[3]["error"], norms[0]["error"]);
  EXPECT_GT(norms[0]["memory"], 1e6);
}

TEST(StudyText, GivesTheLimitOfThreeLevels) {
  std::vector<LevelResult> levels;
  for (int level = 1; level <= 3; ++level) {
    const int cells = 10 << (3 * level);
    levels.push_back(level_with(level, cells, {{"grey", "probe:a:0", 2 + std::pow(cells, -2.0 / 3), {}}}));
  }
  const auto rows = study_rows(levels, Refinement::mesh);
  const json study = json::parse(study_json(rows, Refinement::mesh, Case(), {}, {}));
  ASSERT_EQ(study["richardson"].size(), 1U);
  EXPECT_NEAR(study["richardson"][0]["value"].get<double>(), 2, 1e-9);
  EXPECT_NEAR(study["richardson"][0]["order"].get<double>(), 2, 1e-6);
  EXPECT_TRUE(has(study_text(rows, levels, Refinement::mesh), "Richardson"));
}

}  // namespace
}  // namespace etendue::study_test
