// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/uniform_emitters.h"

#include <gtest/gtest.h>

namespace etendue::uniform_emitters_test {
namespace {

/// A square of the plane z = height from (x, y) in two triangles that shine upwards.
void add_square(double x, double y, double height, double radiance, std::vector<EmitterPart>& parts) {
  const Vec3 a(x, y, height), b(x + 1, y, height), c(x + 1, y + 1, height), d(x, y + 1, height);
  parts.push_back({{a, b, c, Vec3::Zero()}, {radiance}});
  parts.push_back({{a, c, d, Vec3::Zero()}, {radiance}});
}

double area_of(const std::vector<EmitterPart>& parts) {
  double area = 0;
  for (const EmitterPart& part : parts)
    area += (part.corners[1] - part.corners[0]).cross(part.corners[2] - part.corners[0]).z() / 2;
  return area;
}

TEST(FewTriangles, MakeUpARectangleOfTwo) {
  std::vector<EmitterPart> parts;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 3; ++j) add_square(i, j, 2, 4, parts);
  const std::vector<EmitterPart> few = few_triangles(parts);
  ASSERT_EQ(few.size(), 2);
  EXPECT_DOUBLE_EQ(area_of(few), 15);
  EXPECT_EQ(few[0].brightness, std::vector<double>{4});
}

// An L, two squares that touch at a corner and a frame round a hole.
TEST(FewTriangles, LeaveAloneWhatIsNotConvex) {
  const std::vector<std::vector<std::pair<int, int>>> shapes = {
      {{0, 0}, {1, 0}, {0, 1}},
      {{0, 0}, {1, 1}},
      {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}}};
  for (const auto& squares : shapes) {
    std::vector<EmitterPart> parts;
    for (const auto& [x, y] : squares) add_square(x, y, 0, 1, parts);
    const std::vector<EmitterPart> few = few_triangles(parts);
    EXPECT_EQ(few.size(), parts.size());
    EXPECT_DOUBLE_EQ(area_of(few), static_cast<double>(squares.size()));
  }
}

// A strip that bends by a millionth is one piece, and its outline would cut off what rays meet first.
TEST(FewTriangles, LeaveAloneWhatIsNotFlat) {
  std::vector<EmitterPart> parts;
  for (int i = 0; i < 4; ++i) add_square(i, 0, 0, 1, parts);
  for (EmitterPart& part : parts)
    for (Vec3& corner : part.corners) corner.z() += 2e-8 * corner.x() * corner.x();
  EXPECT_EQ(uniform_emitters(parts, 64)->size(), 1);
  EXPECT_EQ(few_triangles(parts).size(), parts.size());
}

// Two lamps in one place shine twice.
TEST(FewTriangles, KeepAllLightOfTrianglesThatCoincide) {
  std::vector<EmitterPart> parts;
  for (int i = 0; i < 3; ++i) add_square(i, 0, 0, 1, parts);
  parts.push_back(parts.front());
  EXPECT_DOUBLE_EQ(area_of(few_triangles(parts)), area_of(parts));
}

TEST(ShinesTo, WhatLiesBeforeItAlone) {
  std::vector<EmitterPart> parts;
  add_square(0, 0, 0, 1, parts);
  EXPECT_TRUE(shines_to(parts[0], {0.3, 0.2, 1e-6}));
  EXPECT_FALSE(shines_to(parts[0], {0.3, 0.2, 1e-12}));
  EXPECT_FALSE(shines_to(parts[0], {3, 2, 0}));
  EXPECT_FALSE(shines_to(parts[0], {0.3, 0.2, -1}));
}

TEST(FewTriangles, KeepPlanesAndRadiancesApart) {
  std::vector<EmitterPart> parts;
  for (const auto& [height, radiance] : {std::pair{0., 1.}, {1., 1.}, {1., 2.}})
    for (int i = 0; i < 3; ++i) add_square(i, radiance, height, radiance, parts);
  EXPECT_EQ(uniform_emitters(parts, 3)->size(), 3);
  EXPECT_FALSE(uniform_emitters(parts, 2));
  EXPECT_EQ(few_triangles(parts).size(), 6);
}

}  // namespace
}  // namespace etendue::uniform_emitters_test
