// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/study_trust.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/study/study_forecast.h"

namespace etendue::study_trust_test {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

LevelResult level_with(int level, int cells, int directions, std::vector<StudyValue> values) {
  LevelResult result;
  result.level = level;
  result.converged = true;
  result.cells = cells;
  result.size = std::cbrt(1.0 / cells);
  result.directions = directions;
  result.seconds = 2;
  result.memory = 100e6;
  result.values = std::move(values);
  return result;
}

std::vector<StudyTrust> trust_of(const std::vector<LevelResult>& levels, Refinement refinement) {
  return study_trust(study_rows(levels, refinement), levels, refinement);
}

TEST(StudyTrust, IsTheDistanceFromAnExactValue) {
  const std::vector<LevelResult> levels = {level_with(1, 10, 8, {{"grey", "probe:a:0", 1.4, 1.0}}),
                                           level_with(2, 80, 8, {{"grey", "probe:a:0", 0.9, 1.0}})};
  const auto trust = trust_of(levels, Refinement::mesh);
  ASSERT_EQ(trust.size(), 1U);
  EXPECT_NEAR(trust[0].error, 0.1, 1e-15);
  EXPECT_EQ(trust[0].basis, TrustBasis::exact);
}

TEST(StudyTrust, IsAQuarterMoreThanTheDistanceFromTheLimitOfThreeLevels) {
  std::vector<LevelResult> levels;
  for (int level = 1; level <= 3; ++level)
    levels.push_back(
        level_with(level, 10 << (3 * level), 8, {{"grey", "probe:a:0", 2 + std::pow(4.0, -level), {}}}));
  const auto trust = trust_of(levels, Refinement::mesh);
  ASSERT_EQ(trust.size(), 1U);
  EXPECT_NEAR(trust[0].error, 1.25 / 64, 1e-6);
  EXPECT_EQ(trust[0].basis, TrustBasis::limit);
}

TEST(StudyTrust, IsTheLastChangeWhereValuesGoToAndFro) {
  std::vector<LevelResult> levels;
  for (int level = 1; level <= 3; ++level)
    levels.push_back(
        level_with(level, 10 << level, 8, {{"grey", "wall:a:incoming", 1 + 0.1 * (level % 2), {}}}));
  const auto trust = trust_of(levels, Refinement::mesh);
  ASSERT_EQ(trust.size(), 1U);
  EXPECT_NEAR(trust[0].error, 0.1, 1e-15);
  EXPECT_EQ(trust[0].basis, TrustBasis::change);
}

TEST(StudyTrust, AddsTheChangesOfMeshAndDirectionsInSquares) {
  const auto value = [](double number) { return std::vector<StudyValue>{{"grey", "probe:a:0", number, {}}}; };
  const std::vector<LevelResult> levels = {level_with(1, 10, 8, value(5)), level_with(2, 10, 32, value(1.4)),
                                           level_with(3, 80, 8, value(1.3)), level_with(4, 80, 32, value(1))};
  const auto trust = trust_of(levels, Refinement::both);
  ASSERT_EQ(trust.size(), 1U);
  EXPECT_NEAR(trust[0].error, 0.5, 1e-15);
}

TEST(StudyTrust, LeavesOutNormsAndBalances) {
  const std::vector<LevelResult> levels = {
      level_with(1, 10, 8, {{"grey", "balance", 1e-3, 0.0}, {"grey", "fluence_L2", 0.1, 0.0}}),
      level_with(2, 80, 8, {{"grey", "balance", 1e-4, 0.0}, {"grey", "fluence_L2", 0.05, 0.0}})};
  EXPECT_TRUE(trust_of(levels, Refinement::mesh).empty());
}

TEST(StudyTrust, IsToldWithTheWorstFirstAndWhatItLeavesOut) {
  const std::vector<LevelResult> levels = {
      level_with(1, 10, 8, {{"red", "probe:a:0", 1.5, {}}, {"red", "probe:a:1", 1.6, {}}}),
      level_with(2, 80, 8, {{"red", "probe:a:0", 1.497, {}}, {"red", "probe:a:1", 2, {}}})};
  const std::string text = trust_text(trust_of(levels, Refinement::mesh), levels, Refinement::mesh, 3);
  EXPECT_TRUE(has(text, "how far to trust level 2 (80 cells, 8 directions)")) << text;
  EXPECT_LT(text.find("probe:a:1"), text.find("probe:a:0")) << text;
  EXPECT_TRUE(has(text, "1 of 2 quantities are within 1 %")) << text;
  EXPECT_TRUE(has(text, "the worst is probe:a:1, band red: 20 %")) << text;
  EXPECT_TRUE(has(text, "--refine directions")) << text;
}

TEST(StudyTrust, OfOneLevelIsNotClaimed) {
  const std::vector<LevelResult> levels = {level_with(1, 10, 8, {{"red", "probe:a:0", 1.5, {}}})};
  const auto trust = trust_of(levels, Refinement::mesh);
  EXPECT_TRUE(trust.empty());
  EXPECT_TRUE(has(trust_text(trust, levels, Refinement::mesh, 1), "ask for --levels 3"));
  EXPECT_TRUE(has(trust_text(trust, levels, Refinement::mesh, 3), "One level alone is done"));
}

StudyRequest study_of(Refinement refinement, int levels) {
  StudyRequest request;
  request.refinement = refinement;
  request.levels = levels;
  return request;
}

TEST(StudyForecast, GrowsByEightWithCellsAndByFourWithDirections) {
  const LevelResult known = level_with(1, 1000, 96, {});
  const auto mesh = forecast_levels(study_of(Refinement::mesh, 3), known, 50e6, 1);
  ASSERT_EQ(mesh.size(), 2U);
  EXPECT_DOUBLE_EQ(mesh[1].cells, 64000);
  EXPECT_DOUBLE_EQ(mesh[1].seconds, 128);
  EXPECT_DOUBLE_EQ(mesh[1].memory, 50e6 + 64 * 50e6) << "what the program takes without cells does not grow";
  const auto directions = forecast_levels(study_of(Refinement::directions, 3), known, 50e6, 1);
  ASSERT_EQ(directions.size(), 2U);
  EXPECT_DOUBLE_EQ(directions[0].cells, 1000);
  EXPECT_DOUBLE_EQ(directions[1].seconds, 32);
  EXPECT_DOUBLE_EQ(directions[1].memory, 100e6);
}

TEST(StudyForecast, RefusesWhatTheMachineDoesNotHold) {
  const LevelForecast level{3, 1e7, 100, 40e9};
  EXPECT_EQ(refusal_of(level, 41e9), "");
  EXPECT_TRUE(has(refusal_of(level, 16e9), "not begun: about 10000000 cells would take some 37 GiB"))
      << refusal_of(level, 16e9);
}

TEST(StudyForecast, IsToldBeforeAndBetweenLevels) {
  EXPECT_TRUE(has(plan_text(study_of(Refinement::mesh, 3)), "64 times the cells and 1 times the directions"));
  const auto levels = forecast_levels(study_of(Refinement::mesh, 3), level_with(1, 1000, 96, {}), 0, 1);
  ASSERT_EQ(levels.size(), 2U);
  const std::string text = forecast_text(levels, 3);
  EXPECT_TRUE(has(text, "study: 1 of 3 levels, about 2 min left")) << text;
  EXPECT_TRUE(has(text, "level 3: about 64000 cells, 2 min, 6 GiB")) << text;
  EXPECT_EQ(forecast_text({}, 3), "");
}

}  // namespace
}  // namespace etendue::study_trust_test
