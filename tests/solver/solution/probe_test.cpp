// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/solution/probe.h"

#include <gtest/gtest.h>

#include "tests/solver/problem/cube_mesh.h"
#include "tests/solver/solution/synthetic_solution.h"

namespace etendue::probe_test {
namespace {

Problem two_bands(const TetrahedralMesh& mesh) {
  const std::vector<PhaseFunction> phase(2, PhaseIsotropic{});
  const std::vector<double> zero(2, 0.0);
  return Problem(mesh, Bands{{"a", "b"}, {}},
                 {{"left", {1.0, 1.0}, {0.0, 0.0}, {0.0, 0.0}, phase, {}},
                  {"right", {1.0, 1.0}, {0.0, 0.0}, {0.0, 0.0}, phase, {}}},
                 {{"floor", zero, zero, zero, {}}, {"rest", zero, zero, zero, {}}});
}

TEST(Probe, ReproducesLinearFields) {
  const TetrahedralMesh mesh = cube_mesh();
  const Problem problem = two_bands(mesh);
  const auto fluence = [](const Vec3& x, int band) { return 1 + band + x.x() + 2 * x.y() + 3 * x.z(); };
  const auto flux = [](const Vec3& x, int band) { return Vec3(x.y(), -x.z(), band + x.x()); };
  const Solution solution = solution_from(problem, fluence, flux);
  const CellLocator locator(mesh);
  // Inside a cell, on a face, on the diagonal edge, at a vertex, on the boundary.
  for (const Vec3& point :
       {Vec3(0.3, 0.5, 0.9), Vec3(0.4, 0.4, 0.1), Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 0), Vec3(1, 0.3, 0.2)}) {
    const std::vector<ProbeValue> values = probe(problem, solution, locator, point);
    ASSERT_EQ(values.size(), 2u);
    for (int band = 0; band < 2; ++band) {
      const ProbeValue& value = values[static_cast<std::size_t>(band)];
      EXPECT_NEAR(value.fluence, fluence(point, band), 1e-13);
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(value.net_flux[static_cast<std::size_t>(axis)], flux(point, band)[axis], 1e-13);
    }
  }
}

TEST(Probe, TakesTheVolumeWeightedMeanWhereCellsMeet) {
  RawMesh raw;  // two tetrahedra on a common face, of heights 1 and 3
  raw.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -3}};
  raw.cells = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  raw.cell_regions = {0, 1};
  raw.region_names = {"left", "right"};
  const TetrahedralMesh mesh(raw);
  const std::vector<PhaseFunction> phase(1, PhaseIsotropic{});
  const Problem problem(mesh, Bands{},
                        {{"left", {1.0}, {0.0}, {0.0}, phase, {}}, {"right", {1.0}, {0.0}, {0.0}, phase, {}}},
                        {{"boundary", {0.0}, {0.0}, {0.0}, {}}});
  Solution solution = solution_from(
      problem, [](const Vec3&, int) { return 0.0; }, [](const Vec3&, int) { return Vec3(0, 0, 0); });
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < 4; ++i)
      solution.fluence[c * 4 + i] = mesh.region(CellIndex(static_cast<int>(c))) == 0 ? 8 : 4;
  const CellLocator locator(mesh);
  EXPECT_NEAR(probe(problem, solution, locator, Vec3(0.2, 0.2, 0))[0].fluence, (1 * 8 + 3 * 4) / 4.0, 1e-14);
  EXPECT_NEAR(probe(problem, solution, locator, Vec3(0.2, 0.2, 0.1))[0].fluence, 8, 1e-14);
}

TEST(Probe, IsEmptyOutside) {
  const TetrahedralMesh mesh = cube_mesh();
  const Problem problem = two_bands(mesh);
  const Solution solution = solution_from(
      problem, [](const Vec3&, int) { return 1.0; }, [](const Vec3&, int) { return Vec3(0, 0, 0); });
  EXPECT_TRUE(probe(problem, solution, CellLocator(mesh), Vec3(1.1, 0.5, 0.5)).empty());
}

}  // namespace
}  // namespace etendue::probe_test
