// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "mesh/geometry/arrangement.h"
#include "tests/mesh/geometry/surface_measures.h"

namespace etendue {
namespace {

using Areas = std::map<std::string, double>;
using Counts = std::map<std::string, int>;

BoxPrimitive box(const std::string& region, const Vec3& min, const Vec3& max) {
  BoxPrimitive primitive;
  primitive.region = region;
  primitive.origin = {"case.toml", 7, "mesh.box"};
  primitive.min = min;
  primitive.max = max;
  return primitive;
}

BoxPrimitive hole(const std::string& name, const Vec3& min, const Vec3& max) {
  BoxPrimitive primitive = box("", min, max);
  primitive.hole = true;
  primitive.name = name;
  return primitive;
}

BoxPrimitive named(BoxPrimitive primitive, const std::map<std::string, std::string>& walls) {
  primitive.walls = walls;
  return primitive;
}

Patch patch(const std::string& wall, const Vec3& min, const Vec3& max) {
  return {wall, min, max, {"case.toml", 30, "mesh.patch"}};
}

void expect_areas(const SurfaceComplex& surface, const Areas& expected) {
  const Areas areas = wall_areas(surface);
  ASSERT_EQ(areas.size(), expected.size());
  for (const auto& [name, area] : expected) {
    ASSERT_TRUE(areas.contains(name)) << name;
    EXPECT_NEAR(areas.at(name), area, 1e-12 * area) << name;
  }
}

std::string fault_of(const Geometry& geometry) {
  try {
    arrange(geometry);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(BoxArrangement, OneBoxHasSixSidesNamedByOutwardAxis) {
  const SurfaceComplex surface = arrange({{box("air", {0, 0, 0}, {4, 3, 2.5})}, {}});
  EXPECT_EQ(surface.facets.size(), 6u);
  EXPECT_EQ(surface.points.size(), 8u);
  expect_areas(surface,
               {{"xmin", 7.5}, {"xmax", 7.5}, {"ymin", 10}, {"ymax", 10}, {"zmin", 12}, {"zmax", 12}});
  EXPECT_EQ(seed_counts(surface), (Counts{{"air", 1}}));
  EXPECT_TRUE(surface.holes.empty());
}

}  // namespace
}  // namespace etendue
