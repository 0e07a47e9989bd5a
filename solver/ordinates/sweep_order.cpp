// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/sweep_order.h"

#include <algorithm>
#include <cmath>

#include "solver/ordinates/cycle_breaking.h"

namespace etendue {
namespace {

/// Which way light passes through a face: from its owner, into its owner, or not at all.
enum class Passage : signed char { into_owner = -1, none = 0, from_owner = 1 };

std::vector<Passage> passages(const TetrahedralMesh& mesh, const Vec3& direction) {
  std::vector<Passage> result(static_cast<std::size_t>(mesh.face_count()));
  const auto normals = mesh.face_area_normals();
  for (std::size_t f = 0; f < result.size(); ++f) {
    const double a = seen_area(normals[f], direction);
    result[f] = a == 0 ? Passage::none : a > 0 ? Passage::from_owner : Passage::into_owner;
  }
  return result;
}

/// The cells in levels: each level needs only those before it.
class LevelSchedule {
 public:
  LevelSchedule(const TetrahedralMesh& mesh, const std::vector<Passage>& passage,
                const std::vector<char>& lagged)
      : mesh_(mesh),
        passage_(passage),
        lagged_(lagged),
        waiting_(static_cast<std::size_t>(mesh.cell_count())) {
    const auto sides = mesh.face_cells();
    for (std::size_t f = static_cast<std::size_t>(mesh.boundary_face_count()); f < sides.size(); ++f)
      if (passage[f] != Passage::none && !lagged[f])
        ++waiting_[static_cast<std::size_t>(sides[f][passage[f] == Passage::from_owner ? 1 : 0])];
  }

  /// Fewer cells than the mesh has where cycles are left.
  void run(std::vector<std::int32_t>& cells, std::vector<std::int32_t>& levels) {
    cells.clear();
    levels.assign(1, 0);
    cells.reserve(waiting_.size());
    for (std::size_t c = 0; c < waiting_.size(); ++c)
      if (waiting_[c] == 0) cells.push_back(static_cast<std::int32_t>(c));
    std::size_t level = 0;
    while (level < cells.size()) {
      const std::size_t end = cells.size();
      levels.push_back(static_cast<std::int32_t>(end));
      for (std::size_t i = level; i < end; ++i) release(cells[i], cells);
      // Along the space-filling curve within a level: neighbours in the order are neighbours in memory.
      std::sort(cells.begin() + static_cast<std::ptrdiff_t>(end), cells.end());
      level = end;
    }
  }

  bool is_waiting(std::int32_t cell) const { return waiting_[static_cast<std::size_t>(cell)] > 0; }

 private:
  void release(std::int32_t cell, std::vector<std::int32_t>& ready) {
    for (const std::int32_t face : mesh_.faces(CellIndex(cell))) {
      const auto f = static_cast<std::size_t>(face);
      if (face < mesh_.boundary_face_count() || lagged_[f]) continue;
      const auto& sides = mesh_.face_cells()[f];
      const int from = passage_[f] == Passage::from_owner ? 0 : 1;
      if (passage_[f] == Passage::none || sides[static_cast<std::size_t>(from)] != cell) continue;
      const std::int32_t behind = sides[static_cast<std::size_t>(1 - from)];
      if (--waiting_[static_cast<std::size_t>(behind)] == 0) ready.push_back(behind);
    }
  }

  const TetrahedralMesh& mesh_;
  const std::vector<Passage>& passage_;
  const std::vector<char>& lagged_;
  std::vector<std::int32_t> waiting_;  ///< [cell] faces that light still has to come through
};

/// Faces to lag so that the cells that still wait can be ordered.
std::vector<std::int32_t> faces_to_lag(const TetrahedralMesh& mesh, const Vec3& direction,
                                       const std::vector<Passage>& passage, const LevelSchedule& schedule) {
  std::vector<FlowEdge> edges;
  for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f) {
    const auto face = static_cast<std::size_t>(f);
    if (passage[face] == Passage::none) continue;
    const auto& sides = mesh.face_cells()[face];
    if (!schedule.is_waiting(sides[0]) || !schedule.is_waiting(sides[1])) continue;
    const bool forward = passage[face] == Passage::from_owner;
    edges.push_back({sides[forward ? 0 : 1], sides[forward ? 1 : 0],
                     std::abs(direction.dot(mesh.area_normal(FaceIndex(f)))), f});
  }
  return feedback_faces(mesh.cell_count(), edges);
}

/// Gives each face a slot while the cells are walked in their order.
class SlotAllocation {
 public:
  SlotAllocation(const TetrahedralMesh& mesh, const std::vector<Passage>& passage, SweepOrder& order)
      : mesh_(mesh), passage_(passage), order_(order), face_slot_(passage.size(), -1) {
    next_ = 1 + mesh.boundary_face_count();
    for (LaggedFace& face : order.lagged) {
      face.upwind_slot = next_++;
      face.downwind_slot = next_++;
      face_slot_[static_cast<std::size_t>(face.face)] = face.upwind_slot;
    }
  }

  void run() {
    order_.slots.resize(4 * order_.cells.size());
    for (std::size_t i = 0; i < order_.cells.size(); ++i) visit(order_.cells[i], &order_.slots[4 * i]);
    order_.slot_count = next_;
  }

 private:
  // Slots to write are taken before those that were read are given back: the four of a cell differ, which
  // the backward sweep needs as much as the forward one.
  void visit(std::int32_t cell, std::int32_t* slots) {
    const auto& faces = mesh_.faces(CellIndex(cell));
    std::int32_t finished[4];
    int finished_count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto f = static_cast<std::size_t>(faces[k]);
      if (passage_[f] == Passage::none) {
        slots[k] = 0;
      } else if (faces[k] < mesh_.boundary_face_count()) {
        slots[k] = 1 + faces[k];
      } else if (is_lagged(f)) {
        // The downwind slot follows the upwind one.
        slots[k] = face_slot_[f] + (leaves(f, cell) ? 0 : 1);
      } else if (leaves(f, cell)) {
        slots[k] = face_slot_[f] = take();
      } else {
        slots[k] = finished[finished_count++] = face_slot_[f];
      }
    }
    free_.insert(free_.end(), finished, finished + finished_count);
  }

  bool is_lagged(std::size_t face) const {
    const std::int32_t first = 1 + mesh_.boundary_face_count();
    return !order_.lagged.empty() && face_slot_[face] >= first &&
           face_slot_[face] < first + 2 * static_cast<std::int32_t>(order_.lagged.size());
  }

  bool leaves(std::size_t face, std::int32_t cell) const {
    return (passage_[face] == Passage::from_owner) == (mesh_.face_cells()[face][0] == cell);
  }

  std::int32_t take() {
    if (free_.empty()) return next_++;
    const std::int32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }

  const TetrahedralMesh& mesh_;
  const std::vector<Passage>& passage_;
  SweepOrder& order_;
  std::vector<std::int32_t> face_slot_;
  std::vector<std::int32_t> free_;
  std::int32_t next_ = 0;
};

}  // namespace

SweepOrder make_sweep_order(const TetrahedralMesh& mesh, const Vec3& direction) {
  SweepOrder order;
  const std::vector<Passage> passage = passages(mesh, direction);
  std::vector<char> lagged(passage.size(), 0);
  LevelSchedule schedule(mesh, passage, lagged);
  schedule.run(order.cells, order.levels);
  if (order.cells.size() < static_cast<std::size_t>(mesh.cell_count())) {
    for (const std::int32_t face : faces_to_lag(mesh, direction, passage, schedule)) {
      order.lagged.push_back({face, 0, 0});
      lagged[static_cast<std::size_t>(face)] = 1;
    }
    LevelSchedule(mesh, passage, lagged).run(order.cells, order.levels);
  }
  SlotAllocation(mesh, passage, order).run();
  return order;
}

}  // namespace etendue
