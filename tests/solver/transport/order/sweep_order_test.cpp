// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/sweep_orders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "solver/angular/sets/direction_set.h"
#include "solver/transport/order/projected_area.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::sweep_order_test {
namespace {

std::vector<std::int32_t> positions(const SweepOrder& order) {
  std::vector<std::int32_t> position(order.visits.size());
  for (std::size_t i = 0; i < order.visits.size(); ++i)
    position[visited_cell(order.visits[i])] = static_cast<std::int32_t>(i);
  return position;
}

std::set<std::uint32_t> visited_cells(const SweepOrder& order) {
  std::set<std::uint32_t> cells;
  for (const SweepVisit& visit : order.visits) cells.insert(visited_cell(visit));
  return cells;
}

/// With all cells in one tile, or some in each.
OwnedOrder order_along(const TetrahedralMesh& mesh, const Vec3& direction, int cells_per_tile = 1 << 30,
                       LevelOrder levels = LevelOrder::neighbours) {
  const SweepGraph graph(mesh);
  const SweepTiles tiles(mesh, static_cast<std::size_t>(cells_per_tile));
  OwnedOrder result{std::vector<SweepVisit>(graph.cell_count()), {}};
  result.order = SweepOrderMaker(graph, tiles, levels).make(direction, result.visits);
  return result;
}

void expect_cells_after_upwind_cells(const TetrahedralMesh& mesh, int cells_per_tile,
                                     LevelOrder levels = LevelOrder::neighbours) {
  const DirectionSet directions = directions_triangular(4);
  for (const Vec3& direction : directions.directions()) {
    const auto [visits, order] = order_along(mesh, direction, cells_per_tile, levels);
    ASSERT_EQ(visited_cells(order).size(), static_cast<std::size_t>(mesh.cell_count()));
    EXPECT_TRUE(order.lagged.empty());
    const std::vector<std::int32_t> position = positions(order);
    for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f) {
      const FaceIndex face(f);
      const double a = projected_area(mesh.area_normal(face), direction);
      if (a == 0) continue;
      const CellIndex upwind = a > 0 ? mesh.owner(face) : mesh.neighbour(face);
      const CellIndex downwind = a > 0 ? mesh.neighbour(face) : mesh.owner(face);
      EXPECT_LT(position[upwind.at()], position[downwind.at()]);
    }
  }
}

TEST(SweepOrder, VisitsEveryCellOnceAfterItsUpwindCells) {
  const TetrahedralMesh mesh = cube_with_ball(2e-3);
  expect_cells_after_upwind_cells(mesh, 1 << 30);
  expect_cells_after_upwind_cells(mesh, 50);
  expect_cells_after_upwind_cells(mesh, 1 << 30, LevelOrder::alike);
}

TEST(SweepOrder, LevelsOfAlikeCellsHoldRunsThroughWhoseFacesLightGoesTheSameWay) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  const Vec3 direction = Vec3(0.3, -0.5, 0.8).normalized();
  const auto changes = [&](LevelOrder levels) {
    const auto [visits, order] = order_along(mesh, direction, 1 << 30, levels);
    const auto leaving = [&, &order = order](std::int32_t position) {
      const CellIndex cell(visited_cell(order.visits[static_cast<std::size_t>(position)]));
      unsigned bits = 0;
      for (unsigned k = 0; k < 4; ++k) {
        const FaceIndex face(mesh.faces(cell)[k]);
        const double out = mesh.owner(face) == cell ? 1 : -1;
        bits |= static_cast<unsigned>(out * projected_area(mesh.area_normal(face), direction) > 0) << k;
      }
      return bits;
    };
    std::size_t most = 0;
    for (std::size_t l = 0; l + 1 < order.levels.size(); ++l) {
      std::size_t count = 0;
      for (std::int32_t i = order.levels[l] + 1; i < order.levels[l + 1]; ++i)
        count += leaving(i) != leaving(i - 1);
      most = std::max(most, count);
    }
    return most;
  };
  // Of 16 patterns 14 occur: light enters a cell somewhere, and leaves it.
  EXPECT_LE(changes(LevelOrder::alike), 13U);
  EXPECT_GT(changes(LevelOrder::neighbours), 13U);
}

TEST(SweepOrder, VisitsACellAsSoonAsItsTileIsOpenAndItsUpwindCellsAreVisited) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  const SweepTiles tiles(mesh, 100);
  ASSERT_GT(tiles.count(), 4);
  const Vec3 direction = Vec3(0.3, -0.5, 0.8).normalized();
  const SweepGraph graph(mesh);
  std::vector<SweepVisit> visits(graph.cell_count());
  const SweepOrder order = SweepOrderMaker(graph, tiles, LevelOrder::neighbours).make(direction, visits);
  ASSERT_EQ(order.steps.size(), static_cast<std::size_t>(tiles.count()) + 1);
  std::vector<std::int32_t> step(order.visits.size());
  for (std::size_t s = 0; s + 1 < order.steps.size(); ++s)
    for (std::int32_t i = order.levels[static_cast<std::size_t>(order.steps[s])];
         i < order.levels[static_cast<std::size_t>(order.steps[s + 1])]; ++i)
      step[visited_cell(order.visits[static_cast<std::size_t>(i)])] = static_cast<std::int32_t>(s);
  std::vector<std::int32_t> earliest(step.size());
  const std::vector<std::int32_t> sequence = tiles.along(direction);
  for (std::size_t c = 0; c < step.size(); ++c)
    earliest[c] = static_cast<std::int32_t>(std::find(sequence.begin(), sequence.end(), tiles.of_cell(c)) -
                                            sequence.begin());
  for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f) {
    const double a = projected_area(mesh.area_normal(FaceIndex(f)), direction);
    const CellIndex owner = mesh.owner(FaceIndex(f)), neighbour = mesh.neighbour(FaceIndex(f));
    const CellIndex upwind = a > 0 ? owner : neighbour, downwind = a > 0 ? neighbour : owner;
    earliest[downwind.at()] = std::max(earliest[downwind.at()], step[upwind.at()]);
  }
  EXPECT_EQ(step, earliest);
}

TEST(SweepTiles, AreBoxesOfFewCellsInTheOrderOfTheLight) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  const SweepTiles tiles(mesh, 100);
  std::vector<int> cells(static_cast<std::size_t>(tiles.count()), 0);
  std::vector<Vec3> low(cells.size(), Vec3::Constant(2)), high(cells.size(), Vec3::Constant(-2));
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const auto tile = static_cast<std::size_t>(tiles.of_cell(static_cast<std::size_t>(c)));
    ++cells[tile];
    low[tile] = low[tile].cwiseMin(mesh.centroid(CellIndex(c)));
    high[tile] = high[tile].cwiseMax(mesh.centroid(CellIndex(c)));
  }
  for (const int count : cells) EXPECT_TRUE(count >= 50 && count <= 100) << count;
  const Vec3 direction(1, -1, 1);
  std::vector<std::int32_t> sequence = tiles.along(direction);
  // No later tile lies wholly upwind of an earlier one.
  for (std::size_t i = 0; i < sequence.size(); ++i)
    for (std::size_t j = i + 1; j < sequence.size(); ++j) {
      const auto first = static_cast<std::size_t>(sequence[i]), later = static_cast<std::size_t>(sequence[j]);
      EXPECT_FALSE(high[later].x() < low[first].x() && low[later].y() > high[first].y() &&
                   high[later].z() < low[first].z());
    }
  const std::vector<std::int32_t> back = tiles.along(-direction);
  std::reverse(sequence.begin(), sequence.end());
  EXPECT_EQ(back, sequence);
}

TEST(SweepOrder, CellsOfOneLevelDoNotWaitForEachOther) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const auto [visits, order] = order_along(mesh, Vec3(0.3, 0.5, 0.8).normalized());
  const std::vector<std::int32_t> position = positions(order);
  const auto level = [&, &order = order](CellIndex cell) {
    return std::upper_bound(order.levels.begin(), order.levels.end(), position[cell.at()]) -
           order.levels.begin();
  };
  for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f)
    EXPECT_NE(level(mesh.owner(FaceIndex(f))), level(mesh.neighbour(FaceIndex(f))));
  EXPECT_EQ(order.levels.front(), 0);
  EXPECT_EQ(order.levels.back(), mesh.cell_count());
}

TEST(SweepOrder, BothSidesAgreeOnParallelFaces) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  for (const Vec3& direction : {Vec3(0.3, 0.5, 0.8), Vec3(0, 0, 1), Vec3(1, 1, 0)}) {
    const auto [visits, order] = order_along(mesh, direction.normalized());
    for (const SweepVisit& visit : order.visits)
      for (std::size_t k = 0; k < 4; ++k) {
        const FaceIndex face(mesh.faces(CellIndex(visited_cell(visit)))[k]);
        const bool parallel = (parallel_faces(visit) >> k & 1) != 0;
        EXPECT_EQ(parallel, projected_area(mesh.area_normal(face), direction.normalized()) == 0);
      }
  }
}

TEST(SweepOrder, LevelsFillWholePackets) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  for (const int cells_per_tile : {1 << 30, 100}) {
    const auto [visits, order] = order_along(mesh, Vec3(0.3, 0.5, 0.8).normalized(), cells_per_tile);
    for (std::size_t l = 0; l + 1 < order.levels.size(); ++l) {
      const std::int32_t size = order.levels[l + 1] - order.levels[l];
      EXPECT_TRUE(size < 8 || size % 8 == 0) << size;
    }
  }
}

/// Walks the order as the kernel does, leaving the cell's number in its slot, and reading back.
void expect_slots_deliver(const TetrahedralMesh& mesh, const SweepOrder& order, const Vec3& direction,
                          bool backwards) {
  const WallSlots walls(mesh);
  std::vector<std::int64_t> content(order.slot_count, -1);
  std::set<std::int32_t> lagged;
  for (const LaggedFace& face : order.lagged) lagged.insert(face.face);
  for (std::size_t i = 0; i < order.visits.size(); ++i) {
    const SweepVisit& visit = order.visits[backwards ? order.visits.size() - 1 - i : i];
    const CellIndex cell(visited_cell(visit));
    for (std::size_t k = 0; k < 4; ++k) {
      const FaceIndex face(mesh.faces(cell)[k]);
      const FaceCode code = unpacked(visit.faces[k]);
      const double side = mesh.owner(face) == cell ? 1 : -1;
      const double a = side * projected_area(mesh.area_normal(face), direction);
      if (a == 0) {
        EXPECT_EQ(code.slot, 0);
      } else if (face.value() < mesh.boundary_face_count()) {
        EXPECT_EQ(code.slot, walls.inflow(face.value()));
        EXPECT_EQ(code.opposite, 3);
        EXPECT_EQ(walls.inside(face.value()).slot, visit.slot);
      } else {
        const CellIndex other = side > 0 ? mesh.neighbour(face) : mesh.owner(face);
        EXPECT_EQ(mesh.faces(other)[code.opposite], face.value());
        const bool waits = a < 0 && !lagged.contains(face.value());
        EXPECT_TRUE(!waits || content[code.slot] == other.value());
      }
    }
    content[visit.slot] = cell.value();
  }
  // The walls read when all is done.
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    EXPECT_EQ(content[walls.inside(f).slot], mesh.owner(FaceIndex(f)).value());
}

TEST(SweepOrder, SlotsDeliverWhatTheUpwindCellLeft) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  for (const Vec3& direction : {Vec3(0.3, 0.5, 0.8), Vec3(-0.9, 0.1, 0.2), Vec3(0, 0, 1)}) {
    for (const int cells_per_tile : {1 << 30, 50}) {
      const auto [visits, order] = order_along(mesh, direction.normalized(), cells_per_tile);
      expect_slots_deliver(mesh, order, direction.normalized(), false);
      expect_slots_deliver(mesh, order, -direction.normalized(), true);
    }
  }
}

TEST(SweepOrder, RecyclesSlots) {
  const TetrahedralMesh mesh = cube_mesh(2.25e-4);
  const WallSlots walls(mesh);
  const auto [visits, order] = order_along(mesh, Vec3(0.3, 0.5, 0.8).normalized());
  EXPECT_LT(order.slot_count - walls.count(), static_cast<std::uint32_t>(mesh.cell_count() / 4));
}

/// The slots of a lagged face are its own: no other cell's radiance passes through them.
void expect_lagged_slots(const TetrahedralMesh& mesh, const SweepOrder& order) {
  std::map<std::uint32_t, std::set<std::uint32_t>> users;
  for (const SweepVisit& visit : order.visits) users[visit.slot].insert(visited_cell(visit));
  for (const LaggedFace& lagged : order.lagged)
    for (const FaceCode& side : {lagged.upwind, lagged.downwind}) {
      ASSERT_EQ(users[side.slot].size(), 1U);
      EXPECT_EQ(mesh.faces(CellIndex(*users[side.slot].begin()))[side.opposite], lagged.face);
    }
}

TEST(SweepOrder, BreaksTheCycleOfATwistedRing) {
  const TetrahedralMesh mesh = cyclic_ring();
  const auto [visits, order] = order_along(mesh, Vec3::UnitZ(), 20);
  ASSERT_FALSE(order.lagged.empty());
  EXPECT_EQ(visited_cells(order).size(), static_cast<std::size_t>(mesh.cell_count()));
  // Only what must be is lagged: one face for each blade's cycle at most, of the ring's many.
  EXPECT_LT(order.lagged.size(),
            static_cast<std::size_t>(mesh.face_count() - mesh.boundary_face_count()) / 8);
  expect_slots_deliver(mesh, order, Vec3::UnitZ(), false);
  expect_slots_deliver(mesh, order, -Vec3::UnitZ(), true);
  expect_lagged_slots(mesh, order);
  EXPECT_TRUE(order_along(mesh, Vec3::UnitX()).order.lagged.empty());
}

}  // namespace
}  // namespace etendue::sweep_order_test
