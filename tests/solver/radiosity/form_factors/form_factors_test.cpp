// SPDX-License-Identifier: AGPL-3.0-or-later
// Every row of validation/reference/form_factors.csv (its origin stands there), by closed forms and by rays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/radiosity/form_factors/exchange_area.h"
#include "tests/solver/radiosity/form_factors/ray_factors.h"
#include "tests/solver/radiosity/reference_shapes.h"

namespace etendue::form_factors_test {
namespace {

std::size_t groups_of(const ReferenceShape& shape) { return std::ranges::max(shape.group_of) + 1; }

double closed_form(const ReferenceShape& shape) {
  double sum = 0;
  for (const TriangleCorners& t : shape.scene) {
    const FlatPatch to({t});
    if (shape.is_element)
      sum += point_factor(Vec3::Zero(), Vec3::UnitZ(), t);
    else
      sum += exchange_area_by_contours(FlatPatch(shape.from), to) / FlatPatch(shape.from).area();
  }
  return sum;
}

TEST(FormFactors, TheTableIsRead) {
  const std::vector<ReferenceShape> shapes = reference_shapes();
  EXPECT_EQ(shapes.size(), 46u);
  EXPECT_EQ(std::ranges::count_if(shapes, [](const ReferenceShape& s) { return s.is_flat; }), 26);
}

// Strips that are 2000 long for infinite ones miss about 1e-8.
TEST(FormFactors, OfPolygonsAreExactToAMillionth) {
  for (const ReferenceShape& shape : reference_shapes()) {
    if (!shape.is_flat) continue;
    EXPECT_NEAR(closed_form(shape), shape.factor, 1e-6) << shape.name;
  }
}

TEST(FormFactors, ByRaysAreWithinThreeStandardErrors) {
  for (const ReferenceShape& shape : reference_shapes()) {
    const RayScene scene(shape.scene);
    const DrawnFactor factor =
        factors_by_rays(shape.from, scene, shape.group_of, groups_of(shape), {.count = 20000, .seed = 1})[0];
    EXPECT_LT(std::abs(factor.value - shape.factor), 3 * factor.error) << shape.name;
    EXPECT_LT(factor.error, 0.004) << shape.name;
  }
}

}  // namespace
}  // namespace etendue::form_factors_test
