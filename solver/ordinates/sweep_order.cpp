// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/sweep_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "mesh/base/errors.h"
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

/// Cells that become ready together, given back in the order of their numbers: along the space-filling curve,
/// so that neighbours in the order are neighbours in memory.
class ReadyCells {
 public:
  explicit ReadyCells(std::size_t cells) : bits_(cells / 64 + 1), first_(bits_.size()) {}

  void add(std::int32_t cell) {
    const auto word = static_cast<std::size_t>(cell) / 64;
    bits_[word] |= std::uint64_t{1} << (static_cast<unsigned>(cell) % 64);
    first_ = std::min(first_, word);
    last_ = std::max(last_, word + 1);
  }

  /// Appends them to `cells` and forgets them.
  void move_to(std::vector<std::uint32_t>& cells) {
    for (std::size_t word = first_; word < last_; ++word)
      for (std::uint64_t& bits = bits_[word]; bits != 0; bits &= bits - 1)
        cells.push_back(static_cast<std::uint32_t>(64 * word) +
                        static_cast<std::uint32_t>(std::countr_zero(bits)));
    first_ = bits_.size();
    last_ = 0;
  }

 private:
  std::vector<std::uint64_t> bits_;
  std::size_t first_;
  std::size_t last_ = 0;
};

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
      if (passage[f] != Passage::none && !is_lagged(f))
        ++waiting_[static_cast<std::size_t>(sides[f][passage[f] == Passage::from_owner ? 1 : 0])];
  }

  /// Fewer cells than the mesh has where cycles are left.
  void run(std::vector<std::uint32_t>& cells, std::vector<std::int32_t>& levels) {
    cells.clear();
    levels.assign(1, 0);
    cells.reserve(waiting_.size());
    ReadyCells ready(waiting_.size());
    for (std::size_t c = 0; c < waiting_.size(); ++c)
      if (waiting_[c] == 0) ready.add(static_cast<std::int32_t>(c));
    std::size_t level = 0;
    for (ready.move_to(cells); level < cells.size(); ready.move_to(cells)) {
      const std::size_t end = cells.size();
      levels.push_back(static_cast<std::int32_t>(end));
      for (std::size_t i = level; i < end; ++i) release(cells[i], ready);
      level = end;
    }
  }

  bool is_waiting(std::int32_t cell) const { return waiting_[static_cast<std::size_t>(cell)] > 0; }

 private:
  bool is_lagged(std::size_t face) const { return !lagged_.empty() && lagged_[face] != 0; }

  /// Lets go of the cells behind.
  void release(std::uint32_t cell, ReadyCells& ready) {
    for (const std::int32_t face : mesh_.faces(CellIndex(cell))) {
      const auto f = static_cast<std::size_t>(face);
      if (passage_[f] == Passage::none || is_lagged(f)) continue;
      const auto& sides = mesh_.face_cells()[f];
      const std::size_t from = passage_[f] == Passage::from_owner ? 0 : 1;
      const std::int32_t behind = sides[1 - from];
      if (behind < 0 || static_cast<std::uint32_t>(sides[from]) != cell) continue;
      if (--waiting_[static_cast<std::size_t>(behind)] == 0) ready.add(behind);
    }
  }

  const TetrahedralMesh& mesh_;
  const std::vector<Passage>& passage_;
  const std::vector<char>& lagged_;   ///< [face], or empty where none is
  std::vector<std::int8_t> waiting_;  ///< [cell] faces that light still has to come through
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

/// Gives each cell a slot while the cells are walked in their order. A slot is taken before any cell that a
/// cell exchanges light with is visited, and given back after the last of them: so the order can be walked
/// backwards as well, and a packet of cells can read all that it needs before it writes.
class SlotAllocation {
 public:
  SlotAllocation(const TetrahedralMesh& mesh, const WallSlots& walls, const std::vector<Passage>& passage,
                 std::vector<LaggedFace>& lagged)
      : mesh_(mesh),
        walls_(walls),
        passage_(passage),
        next_(walls.count()),
        slot_(walls.of_cells().begin(), walls.of_cells().end()),
        visits_left_(slot_.size(), 1) {
    // What a lagged face delivers is put there before a sweep and read after it.
    for (LaggedFace& face : lagged)
      for (FaceCode* side : {&face.upwind, &face.downwind}) {
        std::uint32_t& slot = slot_[side->slot];
        if (slot == 0) slot = next_++;
        side->slot = slot;
      }
    first_recycled_ = next_;
    const auto sides = mesh.face_cells();
    for (std::size_t f = static_cast<std::size_t>(mesh.boundary_face_count()); f < sides.size(); ++f)
      if (passage[f] != Passage::none)
        for (const std::int32_t cell : sides[f]) ++visits_left_[static_cast<std::size_t>(cell)];
  }

  void run(std::span<const std::uint32_t> cells, std::vector<SweepVisit>& visits) {
    visits.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) visit(cells[i], visits[i]);
  }

  std::uint32_t slot_count() const { return next_; }

 private:
  void visit(std::uint32_t cell, SweepVisit& result) {
    const auto& faces = mesh_.faces(CellIndex(cell));
    std::uint32_t parallel = 0;
    std::uint32_t concerned[5] = {cell};
    std::size_t count = 1;
    result.slot = take(cell);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto f = static_cast<std::size_t>(faces[k]);
      if (passage_[f] == Passage::none) {
        parallel |= std::uint32_t{1} << (visit_cell_bits + static_cast<int>(k));
      } else if (faces[k] < mesh_.boundary_face_count()) {
        result.faces[k] = packed({walls_.inflow(faces[k]), 3});
      } else {
        const auto& sides = mesh_.face_cells()[f];
        const CellIndex other(sides[static_cast<std::uint32_t>(sides[0]) == cell ? 1 : 0]);
        concerned[count++] = static_cast<std::uint32_t>(other.value());
        result.faces[k] = packed({take(static_cast<std::uint32_t>(other.value())),
                                  opposite_node(mesh_, other, FaceIndex(faces[k]))});
      }
    }
    result.cell_and_parallel = cell | parallel;
    for (std::size_t i = 0; i < count; ++i) give_back(concerned[i]);
  }

  std::uint32_t take(std::uint32_t cell) {
    std::uint32_t& slot = slot_[cell];
    if (slot != 0) return slot;
    if (free_.empty()) return slot = next_++;
    slot = free_.back();
    free_.pop_back();
    return slot;
  }

  void give_back(std::uint32_t cell) {
    if (--visits_left_[cell] == 0 && slot_[cell] >= first_recycled_) free_.push_back(slot_[cell]);
  }

  const TetrahedralMesh& mesh_;
  const WallSlots& walls_;
  const std::vector<Passage>& passage_;
  std::uint32_t next_;
  std::uint32_t first_recycled_ = 0;
  std::vector<std::uint32_t> slot_;       ///< [cell] 0 until it is taken
  std::vector<std::int8_t> visits_left_;  ///< [cell] its own and those of the cells around
  std::vector<std::uint32_t> free_;
};

/// The visits must be able to name all cells.
void check_size(const TetrahedralMesh& mesh) {
  if (mesh.cell_count() >= most_cells)
    throw InputError(
        fmt::format("the mesh has {} cells; a sweep can order {}", mesh.cell_count(), most_cells - 1));
}

}  // namespace

SweepOrder make_sweep_order(const TetrahedralMesh& mesh, const WallSlots& walls, const Vec3& direction) {
  check_size(mesh);
  SweepOrder order;
  std::vector<std::uint32_t> cells;
  const std::vector<Passage> passage = passages(mesh, direction);
  std::vector<char> lagged;
  LevelSchedule schedule(mesh, passage, lagged);
  schedule.run(cells, order.levels);
  if (cells.size() < static_cast<std::size_t>(mesh.cell_count())) {
    lagged.assign(passage.size(), 0);
    for (const std::int32_t f : faces_to_lag(mesh, direction, passage, schedule)) {
      const FaceIndex face(f);
      const bool from_owner = passage[face.at()] == Passage::from_owner;
      const CellIndex upwind = from_owner ? mesh.owner(face) : mesh.neighbour(face);
      const CellIndex downwind = from_owner ? mesh.neighbour(face) : mesh.owner(face);
      order.lagged.push_back(
          {f,
           {static_cast<std::uint32_t>(upwind.value()), opposite_node(mesh, upwind, face)},
           {static_cast<std::uint32_t>(downwind.value()), opposite_node(mesh, downwind, face)}});
      lagged[face.at()] = 1;
    }
    LevelSchedule(mesh, passage, lagged).run(cells, order.levels);
  }
  SlotAllocation allocation(mesh, walls, passage, order.lagged);
  allocation.run(cells, order.visits);
  order.slot_count = allocation.slot_count();
  return order;
}

}  // namespace etendue
