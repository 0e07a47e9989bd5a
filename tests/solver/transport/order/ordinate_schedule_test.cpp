// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/ordinate_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "solver/transport/sweep/transport_sweep.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::ordinate_schedule_test {
namespace {

/// An absorbing cube that shines, with mirrors at these walls and black ones elsewhere.
Problem cube_with_mirrors(const TetrahedralMesh& mesh, const std::set<std::string>& mirrors,
                          double scattering = 0) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0.2, 0, mirrors.count(name) > 0 ? 0.9 : 0));
    walls.back().name = name;
  }
  return Problem(mesh, Bands{}, {uniform_medium(1, 0.3, scattering, 1, PhaseHenyeyGreenstein{0.4})}, walls);
}

std::vector<int> places(const OrdinateSchedule& schedule, int count) {
  std::vector<int> place_of(static_cast<std::size_t>(count), -1);
  for (int place = 0; place < count; ++place) place_of[schedule.ordinate(place).at()] = place;
  return place_of;
}

TEST(OrdinateSchedule, KeepsTheBatchesOfTheSetWithoutMirrors) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const OrdinateSchedule schedule(cube_with_mirrors(mesh, {}), directions_ldfe_sq(1), Batches::of_neighbours);
  EXPECT_EQ(schedule.batch(), 16);
  EXPECT_EQ(schedule.batch_count(), 6);
  for (int place = 0; place < 96; ++place) EXPECT_EQ(schedule.ordinate(place).value() / 16, place / 16);
  EXPECT_FALSE(schedule.knows_reflections(Vec3::UnitX()));
}

std::array<bool, 3> signs(const Vec3& direction) {
  return {direction.x() < 0, direction.y() < 0, direction.z() < 0};
}

TEST(OrdinateSchedule, GroupsHoldOrdinatesOfOneOctantAndEveryOneOnce) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  for (const auto& [mirrors, batches] : {std::pair(std::set<std::string>{}, Batches::of_neighbours),
                                         {{"xmin", "zmax"}, Batches::of_neighbours},
                                         {{}, Batches::of_images},
                                         {{"xmin", "zmax"}, Batches::of_images}})
    for (const DirectionSet& set :
         {directions_product(8), directions_ldfe_sq(1), directions_level_symmetric(8)}) {
      const OrdinateSchedule schedule(cube_with_mirrors(mesh, mirrors), set, batches);
      std::set<std::int32_t> seen;
      for (std::int32_t first = 0; first < schedule.place_count(); first = schedule.group_end(first)) {
        const std::int32_t end = schedule.group_end(first);
        ASSERT_LT(first, end);
        EXPECT_LE(end - first, largest_group);
        EXPECT_EQ(first / schedule.batch(), (end - 1) / schedule.batch());
        for (std::int32_t place = first; place < end; ++place) {
          EXPECT_EQ(signs(set.direction(schedule.ordinate(place))),
                    signs(set.direction(schedule.ordinate(first))));
          seen.insert(schedule.ordinate(place).value());
          const OrdinateIndex opposite(schedule.ordinate(place).value() ^ 1);
          EXPECT_EQ(schedule.ordinate(schedule.place_of(opposite)), opposite);
          EXPECT_EQ(schedule.place_of(opposite) / schedule.batch(), first / schedule.batch());
        }
      }
      EXPECT_EQ(seen.size(), static_cast<std::size_t>(set.count()));
    }
  // Sixteen pairs of an octant are two batches, each of them one group and its opposite.
  const OrdinateSchedule schedule(cube_with_mirrors(mesh, {}), directions_product(8), Batches::of_neighbours);
  for (std::int32_t place = 0; place < 128; ++place)
    EXPECT_EQ(schedule.group_end(place), (place / 8 + 1) * 8);
}

TEST(OrdinateSchedule, OrdinatesFollowInTheirBatchWhatMirrorsTurnIntoThem) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem = cube_with_mirrors(mesh, {"xmin", "xmax", "ymax", "zmin"});
  for (const auto& [set, batches] : {std::pair(directions_ldfe_sq(1), Batches::of_neighbours),
                                     std::pair(directions_triangular(4), Batches::of_neighbours),
                                     std::pair(directions_lebedev(17), Batches::of_neighbours),
                                     std::pair(directions_ldfe_sq(1), Batches::of_images)}) {
    const OrdinateSchedule schedule(problem, set, batches);
    const int batch = schedule.batch();
    const std::vector<int> place = places(schedule, set.count());
    EXPECT_EQ(std::count(place.begin(), place.end(), -1), 0);
    EXPECT_NE(schedule.knows_reflections(Vec3::UnitX()), schedule.knows_reflections(-Vec3::UnitX()));
    EXPECT_TRUE(schedule.knows_reflections(Vec3::UnitY()));
    EXPECT_TRUE(schedule.knows_reflections(-Vec3::UnitZ()));
    for (const Vec3& normal :
         {Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(-Vec3::UnitZ())})
      for (int m = 0; m < set.count(); ++m) {
        const OrdinateIndex into(m);
        if (!schedule.knows_reflections(normal) || set.direction(into).dot(normal) >= 0) continue;
        const int from = set.mirrored(into, normal);
        EXPECT_LT(place[static_cast<std::size_t>(from)], place[into.at()]);
        EXPECT_EQ(place[static_cast<std::size_t>(from)] / batch, place[into.at()] / batch);
      }
  }
}

/// Number of directions whose reflection is kept for the next sweep.
std::size_t traces(const TetrahedralMesh& mesh, const std::set<std::string>& mirrors) {
  const Problem problem = cube_with_mirrors(mesh, mirrors);
  const std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count()), 0.3);
  const DirectionSet directions = directions_ldfe_sq(1);
  const SolveOptions options = tight_options();
  return TransportSweep(problem, directions, extinction, options).layout().mirrors;
}

TEST(OrdinateSchedule, OnlyOneOfTwoFacingMirrorsWaitsForTheNextSweep) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  EXPECT_EQ(traces(mesh, {"xmin", "ymax", "zmin"}), 0u);
  const std::size_t facing = traces(mesh, {"xmin", "xmax"});
  EXPECT_GT(facing, 0u);
  EXPECT_EQ(traces(mesh, {"xmin", "xmax", "ymin", "zmax"}), facing);
}

TEST(OrdinateSchedule, MirrorsAtRightAnglesTakeOneSweep) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const DirectionSet directions = directions_ldfe_sq(1);
  const Problem problem = cube_with_mirrors(mesh, {"xmax", "ymin", "zmin"});
  const Solution solution = solve(problem, directions, tight_options());
  EXPECT_EQ(solution.convergence[0].sweeps, 1);
  EXPECT_TRUE(solution.converged());
  // One more sweep changes nothing.
  const std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count()), 0.3);
  const SolveOptions options = tight_options();
  TransportSweep sweep(problem, directions, extinction, options);
  TransportState dark(sweep.layout()), first(sweep.layout()), second(sweep.layout());
  sweep.apply(dark, first);
  sweep.apply(first, second);
  EXPECT_TRUE(std::equal(first.values().begin(), first.values().end(), second.values().begin()));
  EXPECT_TRUE(std::equal(solution.fluence.begin(), solution.fluence.begin() + 4, first.fluence().begin()));
}

TEST(OrdinateSchedule, SameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const Problem problem = cube_with_mirrors(mesh, {"xmin", "xmax", "ymin", "ymax", "zmax"}, 0.5);
  SolveOptions options = tight_options();
  options.tolerance = 1e-6;
  options.threads = 1;
  const Solution one = solve(problem, directions_triangular(6), options);
  ASSERT_TRUE(one.converged());
  for (const int threads : {2, 3, 4}) {
    options.threads = threads;
    EXPECT_EQ(solve(problem, directions_triangular(6), options).fluence, one.fluence);
  }
}

}  // namespace
}  // namespace etendue::ordinate_schedule_test
