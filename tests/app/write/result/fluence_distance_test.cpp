// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/fluence_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/write/vtk/vtk_files.h"
#include "tests/app/write/sample_run.h"

namespace etendue::fluence_distance_test {
namespace {

using test::SampleRun;
using test::ScratchFolder;

/// Sets the fluence of both bands to a function of the place.
template <class Function>
std::filesystem::path written(const ScratchFolder& folder, const std::string& name, Function fluence) {
  SampleRun run({"red", "blue"});
  run.input.output.fields = {"fluence"};
  std::size_t at = 0;
  for (const auto& vertices : run.mesh.cell_vertices())
    for (const std::int32_t v : vertices)
      for (int band = 0; band < 2; ++band)
        run.solution.fluence[at++] = fluence(run.mesh.point(VertexIndex(v)), band);
  const std::filesystem::path path = folder.path() / name;
  write_fields(run.result(), path, path);
  return path;
}

TEST(FluenceDistance, IsZeroBetweenAFieldAndItself) {
  const ScratchFolder folder;
  const auto path =
      written(folder, "a.vtu", [](const Vec3& x, int band) { return 1 + x.x() - band * x.z(); });
  const auto errors = fluence_distance(path, path);
  ASSERT_EQ(errors.size(), 2U);
  for (const FluenceError& error : errors) {
    EXPECT_LT(error.l2, 1e-14);
    EXPECT_LT(error.linf, 1e-14);
  }
}

TEST(FluenceDistance, IsRelativeToTheOtherField) {
  const ScratchFolder folder;
  const auto one = written(folder, "one.vtu", [](const Vec3&, int) { return 1.0; });
  const auto other =
      written(folder, "other.vtu", [](const Vec3&, int band) { return band == 0 ? 4.0 : 0.5; });
  const auto errors = fluence_distance(one, other);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_NEAR(errors[0].l2, 0.75, 1e-14);
  EXPECT_NEAR(errors[1].l2, 1.0, 1e-14);
  EXPECT_NEAR(errors[1].linf, 1.0, 1e-14);
}

TEST(FluenceDistance, IntegratesTheSquareOfALinearDifference) {
  // The integral of x^2 over the cube is 1/3.
  const ScratchFolder folder;
  const auto one = written(folder, "one.vtu", [](const Vec3& x, int) { return 1 + x.x(); });
  const auto other = written(folder, "other.vtu", [](const Vec3&, int) { return 1.0; });
  EXPECT_NEAR(fluence_distance(one, other)[0].l2, std::sqrt(1.0 / 3), 1e-12);
}

TEST(FluenceDistance, IsNotKnownWithoutAFluence) {
  const ScratchFolder folder;
  const auto path = written(folder, "a.vtu", [](const Vec3&, int) { return 1.0; });
  EXPECT_TRUE(fluence_distance(path, folder.path() / "missing.vtu").empty());
  SampleRun run({"red", "blue"});
  run.input.output.fields = {"media"};
  const std::filesystem::path bare = folder.path() / "bare.vtu";
  write_fields(run.result(), bare, bare);
  EXPECT_TRUE(fluence_distance(bare, path).empty());
}

}  // namespace
}  // namespace etendue::fluence_distance_test
