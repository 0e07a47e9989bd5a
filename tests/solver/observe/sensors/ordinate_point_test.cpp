// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/ordinate_point.h"

#include <gtest/gtest.h>

#include <numeric>

#include "solver/solution/probe.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::ordinate_point_test {
namespace {

// The sums that a run's own meter and probe show, in cells, on a face between them and on a wall.
TEST(OrdinatePoint, ShowsWhatMetersAndProbesShow) {
  const TetrahedralMesh mesh = cube_with_ball(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.4, 1, 0.3), uniform_wall(1, 0.1, 0.4, 0));
  const DirectionSet directions = directions_product(4);
  const CellLocator locator(mesh);
  const Vec3 normal = Vec3(0.3, -0.5, 0.6).normalized();
  Vec3 between = Vec3::Zero();
  for (const std::int32_t v : mesh.vertices(FaceIndex(mesh.face_count() - 1)))
    between += mesh.point(VertexIndex(v)) / 3;
  const std::vector<Vec3> points = {{0.31, 0.22, 0.13}, between, {0.4, 0.3, 0}};
  SolveOptions options = tight_options();
  for (const Vec3& point : points) options.meters.push_back({locator.find(point), normal});
  options.keep_ordinates.resize(directions.directions().size());
  std::iota(options.keep_ordinates.begin(), options.keep_ordinates.end(), 0);
  const Solution solution = solve(problem, directions, options);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const OrdinatesAtPoint found =
        ordinates_at_point(mesh, {directions, solution}, options.meters[i].cells, normal);
    const double fluence = probe(problem, solution, locator, points[i])[0].fluence;
    EXPECT_EQ(options.meters[i].cells.size(), i == 1 ? 2U : 1U);
    EXPECT_NEAR(found.irradiance[0] / solution.meters[i], 1, 1e-9);
    EXPECT_NEAR(found.fluence[0] / fluence, 1, 1e-9);
  }
}

}  // namespace
}  // namespace etendue::ordinate_point_test
