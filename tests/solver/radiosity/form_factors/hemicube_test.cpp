// SPDX-License-Identifier: AGPL-3.0-or-later
// Every row of validation/reference/form_factors.csv (its origin stands there), by hemicubes.
#include "tests/solver/radiosity/form_factors/hemicube.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/solver/radiosity/reference_shapes.h"

namespace etendue::hemicube_test {
namespace {

TEST(Hemicube, FactorsOverSubPatchesAreWithinAThousandth) {
  Hemicube hemicube(64);
  for (const ReferenceShape& shape : reference_shapes()) {
    const int sub_patches = std::max<int>(24 * 24, static_cast<int>(shape.from.size()));
    const double factor = factors_by_hemicube(shape.from, sub_patches, hemicube, shape.scene, shape.group_of,
                                              std::ranges::max(shape.group_of) + 1)[0];
    EXPECT_NEAR(factor, shape.factor, 1e-3) << shape.name;
  }
}

}  // namespace
}  // namespace etendue::hemicube_test
