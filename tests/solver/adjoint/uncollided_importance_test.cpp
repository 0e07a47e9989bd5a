// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/adjoint/uncollided_importance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/field_view.h"
#include "solver/adjoint/solve_adjoint.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::uncollided_importance_test {
namespace {

using std::numbers::pi;

const Vec3 center(0.5, 0.5, 0.5);

/// A cube of a medium with walls.
struct Room {
  TetrahedralMesh mesh = cube_mesh(2e-3);
  Problem problem;
  Room(double absorption, double scattering, const Wall& wall)
      : problem(uniform_problem(mesh, uniform_medium(1, absorption, scattering, 0), wall)) {}
};

/// The importance of a response with its uncollided part along rays.
Solution importance_of(const Problem& problem, const Response& response) {
  const std::vector<DirectionSet> sets = {directions_product(4)};
  const SolveOptions options = tight_options();
  Solution importance = solve_adjoint({}, problem, sets, response, options).importance;
  EXPECT_EQ(follow_uncollided_importance(problem, sets, response, options, importance), "");
  return importance;
}

double total_arriving(const TetrahedralMesh& mesh, const Solution& solution) {
  double sum = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    sum += mesh.area(FaceIndex(f)) * ConstFaceField(solution.irradiance, 1).mean(FaceIndex(f), 0);
  return sum;
}

// What a point's importance brings to a wall is what light of that point would: cos/r^2 exp(-sigma r).
TEST(UncollidedImportance, OfAPointIsThatOfALampThere) {
  const Room room(0.7, 0, uniform_wall(1, 0, 0, 0));
  const CellLocator locator(room.mesh);
  const Solution importance = importance_of(room.problem, PointFluence{locator.find(center)});
  ASSERT_GT(room.mesh.boundary_face_count(), 0);
  for (std::int32_t f = 0; f < room.mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const Vec3 way = room.mesh.centroid(face) - center;
    const double cosine = way.normalized().dot(room.mesh.area_normal(face).normalized());
    const double expected = cosine / way.squaredNorm() * std::exp(-0.7 * way.norm());
    EXPECT_NEAR(ConstFaceField(importance.irradiance, 1).mean(face, 0), expected, 0.03 * expected);
  }
}

TEST(UncollidedImportance, OfIrradianceLeavesAlongTheNormal) {
  const Room room(0, 0, uniform_wall(1, 0, 0, 0));
  const CellLocator locator(room.mesh);
  const Solution importance =
      importance_of(room.problem, MeanIrradiance{{locator.find(center)}, Vec3::UnitX()});
  EXPECT_NEAR(total_arriving(room.mesh, importance), pi, 1e-3 * pi);
  int behind = 0;
  for (std::int32_t f = 0; f < room.mesh.boundary_face_count(); ++f) {
    const auto wall = static_cast<std::size_t>(room.mesh.wall(FaceIndex(f)));
    if (room.mesh.wall_names()[wall] != "xmin") continue;
    EXPECT_NEAR(ConstFaceField(importance.irradiance, 1).mean(FaceIndex(f), 0), 0, 1e-10);
    ++behind;
  }
  EXPECT_GT(behind, 0);
}

// Between three black walls and three perfect mirrors all of a point's importance, 4 pi, ends on the black
// ones.
TEST(UncollidedImportance, FollowsMirrors) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, name.ends_with("min") ? 1 : 0));
    walls.back().name = name;
  }
  const Problem problem(mesh, {}, {uniform_medium(1, 0, 0, 0)}, walls);
  const CellLocator locator(mesh);
  const Solution importance = importance_of(problem, PointFluence{locator.find({0.3, 0.6, 0.4})});
  double black = 0;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (walls[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))].specular[0] == 0)
      black += mesh.area(FaceIndex(f)) * ConstFaceField(importance.irradiance, 1).mean(FaceIndex(f), 0);
  EXPECT_NEAR(black, 4 * pi, 1e-3 * pi);
}

TEST(UncollidedImportance, IsLeftOutWhereTheResponseIsLarge) {
  const Room room(0.7, 0, uniform_wall(1, 0, 0, 0));
  Solution importance;
  EXPECT_EQ(follow_uncollided_importance(room.problem, {directions_product(4)}, ArrivingPower{0},
                                         tight_options(), importance),
            "the response is no small wall or region, or rays do not follow walls here");
}

}  // namespace
}  // namespace etendue::uncollided_importance_test
