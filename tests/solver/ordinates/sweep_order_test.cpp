// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/sweep_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "solver/angle/direction_set.h"
#include "tests/solver/ordinates/sample_problems.h"

namespace etendue {
namespace {

std::vector<std::int32_t> positions(const SweepOrder& order) {
  std::vector<std::int32_t> position(order.cells.size());
  for (std::size_t i = 0; i < order.cells.size(); ++i)
    position[static_cast<std::size_t>(order.cells[i])] = static_cast<std::int32_t>(i);
  return position;
}

TEST(SweepOrder, VisitsEveryCellOnceAfterItsUpwindCells) {
  const TetrahedralMesh mesh = cube_with_ball(2e-3);
  const DirectionSet directions = directions_triangular(4);
  for (const Vec3& direction : directions.directions()) {
    const SweepOrder order = make_sweep_order(mesh, direction);
    ASSERT_EQ(std::set<std::int32_t>(order.cells.begin(), order.cells.end()).size(),
              static_cast<std::size_t>(mesh.cell_count()));
    EXPECT_TRUE(order.lagged.empty());
    const std::vector<std::int32_t> position = positions(order);
    for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f) {
      const FaceIndex face(f);
      const double a = seen_area(mesh.area_normal(face), direction);
      if (a == 0) continue;
      const CellIndex upwind = a > 0 ? mesh.owner(face) : mesh.neighbour(face);
      const CellIndex downwind = a > 0 ? mesh.neighbour(face) : mesh.owner(face);
      EXPECT_LT(position[upwind.at()], position[downwind.at()]);
    }
  }
}

TEST(SweepOrder, CellsOfOneLevelDoNotWaitForEachOther) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const SweepOrder order = make_sweep_order(mesh, Vec3(0.3, 0.5, 0.8).normalized());
  const std::vector<std::int32_t> position = positions(order);
  const auto level = [&](CellIndex cell) {
    return std::upper_bound(order.levels.begin(), order.levels.end(), position[cell.at()]) -
           order.levels.begin();
  };
  for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f)
    EXPECT_NE(level(mesh.owner(FaceIndex(f))), level(mesh.neighbour(FaceIndex(f))));
  EXPECT_EQ(order.levels.front(), 0);
  EXPECT_EQ(order.levels.back(), mesh.cell_count());
}

/// Walks the order as the kernel does, writing into every slot the cell and face that write it, and reading
/// back.
void expect_slots_deliver(const TetrahedralMesh& mesh, const SweepOrder& order, const Vec3& direction,
                          bool backwards) {
  std::vector<std::int32_t> content(static_cast<std::size_t>(order.slot_count), -1);
  std::set<std::int32_t> lagged;
  for (const LaggedFace& face : order.lagged) lagged.insert(face.face);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) content[1 + static_cast<std::size_t>(f)] = f;
  for (std::size_t i = 0; i < order.cells.size(); ++i) {
    const std::size_t at = backwards ? order.cells.size() - 1 - i : i;
    const CellIndex cell(order.cells[at]);
    std::set<std::int32_t> own;
    for (std::size_t k = 0; k < 4; ++k) {
      const FaceIndex face(mesh.faces(cell)[k]);
      const std::int32_t slot = order.slots[4 * at + k];
      const double side = mesh.owner(face) == cell ? 1 : -1;
      const double a = side * seen_area(mesh.area_normal(face), direction);
      EXPECT_EQ(slot == 0, a == 0);
      if (a == 0) continue;
      EXPECT_TRUE(own.insert(slot).second) << "two faces of a cell share a slot";
      if (a > 0 || lagged.contains(face.value())) continue;
      EXPECT_EQ(content[static_cast<std::size_t>(slot)], face.value());
    }
    // The kernel writes all four, also those that it has read.
    for (std::size_t k = 0; k < 4; ++k)
      content[static_cast<std::size_t>(order.slots[4 * at + k])] = mesh.faces(cell)[k];
  }
}

TEST(SweepOrder, SlotsDeliverWhatTheUpwindCellWrote) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  for (const Vec3& direction : {Vec3(0.3, 0.5, 0.8), Vec3(-0.9, 0.1, 0.2), Vec3(0, 0, 1)}) {
    const SweepOrder order = make_sweep_order(mesh, direction.normalized());
    expect_slots_deliver(mesh, order, direction.normalized(), false);
    expect_slots_deliver(mesh, order, -direction.normalized(), true);
  }
}

TEST(SweepOrder, BreaksTheCycleOfATwistedRing) {
  const TetrahedralMesh mesh = cyclic_ring();
  const SweepOrder order = make_sweep_order(mesh, Vec3::UnitZ());
  ASSERT_FALSE(order.lagged.empty());
  EXPECT_EQ(std::set<std::int32_t>(order.cells.begin(), order.cells.end()).size(),
            static_cast<std::size_t>(mesh.cell_count()));
  // Only what must be is lagged: one face for each blade's cycle at most, of the ring's many.
  EXPECT_LT(order.lagged.size(),
            static_cast<std::size_t>(mesh.face_count() - mesh.boundary_face_count()) / 8);
  expect_slots_deliver(mesh, order, Vec3::UnitZ(), false);
  expect_slots_deliver(mesh, order, -Vec3::UnitZ(), true);
  EXPECT_TRUE(make_sweep_order(mesh, Vec3::UnitX()).lagged.empty());
}

TEST(SweepOrder, RecyclesSlots) {
  const TetrahedralMesh mesh = cube_mesh(2.25e-4);
  const SweepOrder order = make_sweep_order(mesh, Vec3(0.3, 0.5, 0.8).normalized());
  EXPECT_LT(order.slot_count - mesh.boundary_face_count(), mesh.face_count() / 8);
}

}  // namespace
}  // namespace etendue
