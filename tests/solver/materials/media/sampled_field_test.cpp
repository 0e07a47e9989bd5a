// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/media/sampled_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>

#include "solver/materials/media/coefficient.h"
#include "tests/solver/problem/cube_mesh.h"

namespace etendue::sampled_field_test {
namespace {

constexpr double pi = 3.14159265358979323846;

double linear(const Vec3& p) { return 1 + 2 * p.x() - p.y() + 0.5 * p.z(); }
double wave(const Vec3& p) { return 2 + std::sin(pi * p.x()) * std::cos(pi * p.y()) * (1 + p.z()); }

std::array<Vec3, 4> corners_of(const TetrahedralMesh& mesh, int cell) {
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = mesh.point(VertexIndex(mesh.vertices(CellIndex(cell))[i]));
  return corners;
}

/// The tetrahedra of a mesh with no values yet.
FieldData field_on(const TetrahedralMesh& mesh, FieldValues on) {
  FieldData data;
  data.points.assign(mesh.points().begin(), mesh.points().end());
  for (const auto& cell : mesh.cell_vertices()) data.cells.push_back({cell[0], cell[1], cell[2], cell[3]});
  data.on = on;
  return data;
}

/// A function at the points, or in the middles of the voxels, of n^3 voxels in a skew box around the unit
/// cube.
template <class Function>
FieldData image_of(int n, FieldValues on, Function function) {
  FieldData data;
  data.on = on;
  ImageGrid& grid = data.image.emplace();
  grid.origin = Vec3(-0.5, -0.5, -0.5);
  grid.steps << 2.0, 0.4, 0, 0, 2.0, 0, 0, 0, 2.0;
  grid.steps /= n;
  const int count = on == FieldValues::on_points ? n + 1 : n;
  grid.points = {n + 1, n + 1, n + 1};
  const double half = on == FieldValues::on_points ? 0 : 0.5;
  for (int k = 0; k < count; ++k)
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i)
        data.values.push_back(function(grid.origin + grid.steps * Vec3(i + half, j + half, k + half)));
  return data;
}

Coefficient coefficient_of(FieldData data) {
  const auto field = std::make_shared<SampledField>("field", std::move(data), std::nullopt);
  return Coefficient(Expression(Formula("f(x,y,z)", {{"f", field}}), {"x", "y", "z"}));
}

Coefficient formula(const char* text) { return Coefficient(Expression(text, {"x", "y", "z"})); }

// Fields remember where they were asked last: so many are asked in turn that some share a memory.
TEST(SampledField, KeepsFieldsApartThatAreAskedInTurn) {
  const TetrahedralMesh mesh = cube_mesh();
  std::vector<SampledField> fields;
  for (int i = 0; i < 9; ++i) {
    FieldData data = field_on(mesh, FieldValues::on_points);
    for (const Vec3& point : data.points) data.values.push_back(i + linear(point));
    fields.emplace_back("field", data, std::nullopt);
  }
  const Vec3 outside(3, 3, 3);
  for (const Vec3& point : {Vec3(0.3, 0.2, 0.9), Vec3(0.3, 0.2, 0.8)})
    for (int repetition = 0; repetition < 2; ++repetition)
      for (std::size_t i = 0; i < fields.size(); ++i) {
        EXPECT_NEAR(fields[i].at(point), static_cast<double>(i) + linear(point), 1e-13);
        EXPECT_TRUE(std::isnan(fields[i].at(outside)));
      }
}

TEST(SampledField, OnPointsOfTetrahedraIsExactForLinearFunctions) {
  const TetrahedralMesh mesh = cube_mesh();
  FieldData data = field_on(mesh, FieldValues::on_points);
  for (const Vec3& point : data.points) data.values.push_back(linear(point));
  const SampledField field("field", data, std::nullopt);
  for (const Vec3& point : {Vec3(0.3, 0.2, 0.9), Vec3(0, 0, 0), Vec3(1, 0.5, 0.5), Vec3(0.7, 0.71, 0.1)})
    EXPECT_NEAR(field.at(point), linear(point), 1e-14);
}

TEST(SampledField, OnCellsOfTheSameMeshIsTheCellsValueExactly) {
  const TetrahedralMesh mesh = cube_mesh();
  FieldData data = field_on(mesh, FieldValues::on_cells);
  for (int c = 0; c < mesh.cell_count(); ++c) data.values.push_back(0.1 + c * c);
  const Coefficient coefficient = coefficient_of(data);
  for (int c = 0; c < mesh.cell_count(); ++c)
    EXPECT_NEAR(coefficient.cell_mean(corners_of(mesh, c)), 0.1 + c * c, 1e-15 * (1 + c * c));
}

TEST(SampledField, OnPointsOfASkewImageIsExactForLinearFunctions) {
  const SampledField field("field", image_of(5, FieldValues::on_points, linear), std::nullopt);
  for (const Vec3& point : {Vec3(0.3, 0.2, 0.9), Vec3(0, 0, 0), Vec3(1, 1, 1)})
    EXPECT_NEAR(field.at(point), linear(point), 1e-14);
}

TEST(SampledField, IsNotKnownOutsideUnlessAValueIsGiven) {
  const FieldData image = image_of(4, FieldValues::on_cells, linear);
  const SampledField field("field", image, std::nullopt), with_outside("field", image, 7);
  EXPECT_TRUE(field.covers(Vec3(1, 1, 1)));
  EXPECT_FALSE(field.covers(Vec3(1, 1, 1.6)));
  EXPECT_TRUE(std::isnan(field.at(Vec3(1, 1, 1.6))));
  EXPECT_TRUE(with_outside.covers(Vec3(1, 1, 1.6)));
  EXPECT_EQ(with_outside.at(Vec3(1, 1, 1.6)), 7);
}

/// The largest error of the means of the cube's cells against those by the formula.
double error_of_means(int n) {
  const TetrahedralMesh mesh = cube_mesh();
  const Coefficient sampled = coefficient_of(image_of(n, FieldValues::on_points, wave));
  const Coefficient exact = formula("2 + sin(pi*x)*cos(pi*y)*(1 + z)");
  double error = 0;
  for (int c = 0; c < mesh.cell_count(); ++c) {
    double mean = 0;  // by the finest rule
    for (const CellRulePoint& node : composite_cell_rule(largest_rule_level))
      mean += node.weight * exact.at(point_at(node.barycentric, corners_of(mesh, c)));
    error = std::max(error, std::abs(sampled.cell_mean(corners_of(mesh, c)) - mean));
  }
  return error;
}

TEST(SampledField, OnPointsIsOfSecondOrderForSmoothFunctions) {
  const double coarse = error_of_means(8), middle = error_of_means(16), fine = error_of_means(32);
  EXPECT_GT(std::log2(coarse / middle), 1.8);
  EXPECT_GT(std::log2(middle / fine), 1.8);
}

TEST(SampledField, KeepsTheIntegralOfVoxelsMuchSmallerThanTheCells) {
  const TetrahedralMesh mesh = cube_mesh();
  // Voxels of 0 and 1 by turns along x: half of the cube, in cells four times as large.
  FieldData data;
  data.on = FieldValues::on_cells;
  ImageGrid& grid = data.image.emplace();
  grid.steps = Eigen::Matrix3d::Identity() / 4;
  grid.points = {5, 5, 5};
  for (int v = 0; v < 64; ++v) data.values.push_back(v % 2);
  const Coefficient coefficient = coefficient_of(data);
  double integral = 0;
  for (int c = 0; c < mesh.cell_count(); ++c)
    integral += mesh.volume(CellIndex(c)) * coefficient.cell_mean(corners_of(mesh, c));
  EXPECT_NEAR(integral, 0.5, 0.005);
}

TEST(CellRule, InPartsIsExactToDegreeFiveToo) {
  for (int level = 0; level <= largest_rule_level; ++level) {
    double weight = 0, moment = 0;
    for (const CellRulePoint& node : composite_cell_rule(level)) {
      weight += node.weight;
      moment += node.weight * std::pow(node.barycentric[1], 3) * std::pow(node.barycentric[2], 2);
      EXPECT_NEAR(std::accumulate(node.barycentric.begin(), node.barycentric.end(), 0.0), 1, 1e-15);
    }
    EXPECT_EQ(composite_cell_rule(level).size(), 14U << (3 * level));
    EXPECT_NEAR(weight, 1, 1e-13);
    EXPECT_NEAR(moment, 6.0 * 6 * 2 / 40320, 1e-15);  // 3! i! j! / (i + j + 3)!
  }
}

TEST(Expression, CallsFunctionsOfThePlaceInCopiesToo) {
  const auto field =
      std::make_shared<SampledField>("field", image_of(4, FieldValues::on_points, linear), std::nullopt);
  const Expression original(Formula("2*f(x,y,z) + x", {{"f", field}}), {"x", "y", "z"});
  const Expression copy = original;
  const Vec3 point(0.25, 0.5, 0.75);
  EXPECT_NEAR(copy(std::span<const double>(point.data(), 3)), 2 * linear(point) + 0.25, 1e-14);
}

}  // namespace
}  // namespace etendue::sampled_field_test
