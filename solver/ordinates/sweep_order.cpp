// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/sweep_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>

#include "solver/ordinates/cycle_breaking.h"
#include "solver/ordinates/ready_cells.h"

namespace etendue {
namespace {

constexpr std::uint32_t all_faces = 0xf;

/// Cells of the largest packet that a kernel works on.
constexpr std::size_t largest_packet = 8;

/// Which way light passes through a face: from its owner, into its owner, or not at all.
enum class Passage : signed char { into_owner = -1, none = 0, from_owner = 1 };

std::vector<Passage> passages(const TetrahedralMesh& mesh, const Vec3& direction) {
  std::vector<Passage> result(static_cast<std::size_t>(mesh.face_count()));
  const auto normals = mesh.face_area_normals();
  for (std::size_t f = 0; f < result.size(); ++f) {
    const double a = seen_area(normals[f], direction);
    result[f] = static_cast<Passage>((a > 0) - (a < 0));
  }
  return result;
}

/// The faces of one cell, bit k for face k.
struct CellPassage {
  std::uint8_t leaving = 0;   ///< light leaves there for a cell that waits for it
  std::uint8_t parallel = 0;  ///< nothing passes
  std::uint8_t passing = 0;   ///< light goes to or comes from another cell
  std::uint8_t out = 0;       ///< light leaves, be it through a wall
};

/// Walks the cells in levels, each of which needs only those before it, and gives each cell a slot. A slot is
/// taken before any cell that its cell exchanges light with is visited, and given back after the last of
/// them: so the order can be walked backwards as well, and a packet of cells can read all that it needs
/// before it writes.
class OrderedWalk {
  struct State {
    std::uint32_t slot;        ///< 0 until it is taken
    std::int16_t waiting;      ///< faces that light still has to come through
    std::int16_t visits_left;  ///< its own and those of the cells around
  };

 public:
  /// `lagged` is [face], or empty where none is.
  OrderedWalk(const SweepGraph& graph, const std::vector<Passage>& passage, const std::vector<char>& lagged)
      : graph_(graph),
        passage_(graph.cell_count()),
        states_(graph.cell_count()),
        first_recycled_(graph.walls().count()) {
    for (std::size_t c = 0; c < passage_.size(); ++c) {
      const SweepGraph::Faces& faces = graph.faces()[c];
      std::uint32_t out = 0, none = 0, lag = 0;
      for (unsigned k = 0; k < 4; ++k) {
        const auto face = static_cast<std::size_t>(faces.numbers[k]);
        out |= static_cast<std::uint32_t>(passage[face] == Passage::from_owner) << k;
        none |= static_cast<std::uint32_t>(passage[face] == Passage::none) << k;
        if (!lagged.empty()) lag |= static_cast<std::uint32_t>(lagged[face]) << k;
      }
      // What leaves the owner enters the other cell.
      out = (out ^ ~faces.owned) & ~none & all_faces;
      const std::uint32_t passing = ~(none | faces.boundary) & all_faces;
      passage_[c] = {static_cast<std::uint8_t>(out & passing & ~lag), static_cast<std::uint8_t>(none),
                     static_cast<std::uint8_t>(passing), static_cast<std::uint8_t>(out)};
      states_[c] = {graph.walls().of_cells()[c],
                    static_cast<std::int16_t>(std::popcount(passing & ~out & ~lag)),
                    static_cast<std::int16_t>(1 + std::popcount(passing))};
    }
  }

  /// A slot of its own for a cell at a lagged face: what such a face delivers is put there before a sweep and
  /// read after it. Before the walk.
  std::uint32_t keep_slot(std::uint32_t cell) {
    if (states_[cell].slot == 0) states_[cell].slot = first_recycled_++;
    return states_[cell].slot;
  }

  /// Fewer visits than cells where cycles are left.
  void run(const SweepTiles& tiles, const Vec3& direction, LevelOrder levels, SweepOrder& order) {
    order.visits.clear();
    order.levels.assign(1, 0);
    order.steps.assign(1, 0);
    order.visits.reserve(states_.size());
    // One before the stack and one behind it are read and written where nothing is taken or given back.
    free_.resize(states_.size() + 2);
    for (std::size_t i = 0; i < states_.size(); ++i)
      free_[1 + i] = first_recycled_ + static_cast<std::uint32_t>(states_.size() - 1 - i);
    free_end_ = free_.data() + 1 + states_.size();
    done_waiting_.resize(states_.size() + 1);
    ReadyCells ready(states_.size(), tiles, direction);
    for (std::size_t c = 0; c < states_.size(); ++c)
      if (states_[c].waiting == 0) ready.add(static_cast<std::uint32_t>(c));
    std::vector<std::uint32_t> level;
    while (ready.open_next()) {
      for (ready.move_to(level); !level.empty(); ready.move_to(level)) {
        // What would not fill the last packet waits for the next level.
        const std::size_t size =
            level.size() < largest_packet ? level.size() : level.size() / largest_packet * largest_packet;
        if (levels == LevelOrder::alike) sort_by_passage(std::span(level).first(size));
        visit_level(std::span(level).first(size), order, ready);
        level.erase(level.begin(), level.begin() + static_cast<std::ptrdiff_t>(size));
      }
      order.steps.push_back(static_cast<std::int32_t>(order.levels.size()) - 1);
    }
    order.slot_count = first_recycled_;
    for (const SweepVisit& visit : order.visits)
      order.slot_count = std::max(order.slot_count, visit.slot + 1);
  }

  bool is_waiting(std::int32_t cell) const { return states_[static_cast<std::size_t>(cell)].waiting > 0; }

 private:
  /// What changes with every visit: in registers, while a level is visited.
  struct Ends {
    std::uint32_t* free_slots;
    std::uint32_t* done_waiting;
  };

  /// Those alike keep their order.
  void sort_by_passage(std::span<std::uint32_t> level) {
    std::array<std::size_t, all_faces + 2> begin{};
    for (const std::uint32_t cell : level) ++begin[passage_[cell].out + std::size_t{1}];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    unsorted_.assign(level.begin(), level.end());
    for (const std::uint32_t cell : unsorted_) level[begin[passage_[cell].out]++] = cell;
  }

  void visit_level(std::span<const std::uint32_t> level, SweepOrder& order, ReadyCells& ready) {
    Ends ends{free_end_, done_waiting_.data()};
    for (const std::uint32_t cell : level) visit(cell, order.visits.emplace_back(), ends);
    free_end_ = ends.free_slots;
    for (const std::uint32_t* cell = done_waiting_.data(); cell != ends.done_waiting; ++cell) {
      __builtin_prefetch(&graph_.behind()[*cell]);
      ready.add(*cell);
    }
    order.levels.push_back(static_cast<std::int32_t>(order.visits.size()));
  }

  [[gnu::always_inline]] void visit(std::uint32_t c, SweepVisit& result, Ends& ends) {
    const std::array<std::uint32_t, 4>& behind = graph_.behind()[c].faces;
    const CellPassage passage = passage_[c];
    result.cell_and_parallel = c | static_cast<std::uint32_t>(passage.parallel) << visit_cell_bits;
    result.slot = take(states_[c], ends);
    for (unsigned k = 0; k < 4; ++k) {
      if ((passage.parallel >> k & 1) != 0) continue;
      result.faces[k] = behind[k];
      if ((passage.passing >> k & 1) == 0) continue;
      const FaceCode code = unpacked(behind[k]);
      State& other = states_[code.slot];
      result.faces[k] = packed({take(other, ends), code.opposite});
      const auto leaves = static_cast<std::int16_t>(passage.leaving >> k & 1);
      other.waiting = static_cast<std::int16_t>(other.waiting - leaves);
      *ends.done_waiting = code.slot;
      ends.done_waiting += (leaves != 0) & (other.waiting == 0);
    }
    // Only now: all slots that a cell uses differ.
    for (unsigned k = 0; k < 4; ++k)
      if ((passage.passing >> k & 1) != 0) give_back(states_[unpacked(behind[k]).slot], ends);
    give_back(states_[c], ends);
  }

  // Whether a slot is there, or free again, is as good as random: choices instead of branches.
  std::uint32_t take(State& state, Ends& ends) const {
    const bool is_new = state.slot == 0;
    const std::uint32_t top = ends.free_slots[-1];
    const std::uint32_t slot = is_new ? top : state.slot;
    ends.free_slots -= is_new;
    state.slot = slot;
    return slot;
  }

  void give_back(State& state, Ends& ends) const {
    --state.visits_left;
    *ends.free_slots = state.slot;
    ends.free_slots += (state.visits_left == 0) & (state.slot >= first_recycled_);
  }

  const SweepGraph& graph_;
  std::vector<CellPassage> passage_;
  std::vector<State> states_;  ///< [cell]
  std::uint32_t first_recycled_;
  std::vector<std::uint32_t> free_;  ///< a stack: slots given back above those never taken
  std::uint32_t* free_end_ = nullptr;
  std::vector<std::uint32_t> done_waiting_;  ///< scratch: what becomes ready in one level
  std::vector<std::uint32_t> unsorted_;      ///< scratch: a level
};

/// Faces to lag so that the cells that still wait can be ordered.
std::vector<std::int32_t> faces_to_lag(const TetrahedralMesh& mesh, const Vec3& direction,
                                       const std::vector<Passage>& passage, const OrderedWalk& walk) {
  std::vector<FlowEdge> edges;
  for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f) {
    const auto face = static_cast<std::size_t>(f);
    if (passage[face] == Passage::none) continue;
    const auto& sides = mesh.face_cells()[face];
    if (!walk.is_waiting(sides[0]) || !walk.is_waiting(sides[1])) continue;
    const bool forward = passage[face] == Passage::from_owner;
    edges.push_back({sides[forward ? 0 : 1], sides[forward ? 1 : 0],
                     std::abs(direction.dot(mesh.area_normal(FaceIndex(f)))), f});
  }
  return feedback_faces(mesh.cell_count(), edges);
}

LaggedFace lagged_face(const TetrahedralMesh& mesh, FaceIndex face, Passage passage, OrderedWalk& walk) {
  const bool from_owner = passage == Passage::from_owner;
  const auto side = [&](CellIndex cell) {
    return FaceCode{walk.keep_slot(static_cast<std::uint32_t>(cell.value())),
                    opposite_node(mesh, cell, face)};
  };
  return {face.value(), side(from_owner ? mesh.owner(face) : mesh.neighbour(face)),
          side(from_owner ? mesh.neighbour(face) : mesh.owner(face))};
}

}  // namespace

SweepOrder make_sweep_order(const SweepGraph& graph, const Vec3& direction, const SweepTiles& tiles,
                            LevelOrder levels) {
  const TetrahedralMesh& mesh = graph.mesh();
  SweepOrder order;
  const std::vector<Passage> passage = passages(mesh, direction);
  std::vector<char> lagged;
  OrderedWalk walk(graph, passage, lagged);
  walk.run(tiles, direction, levels, order);
  if (order.visits.size() == static_cast<std::size_t>(mesh.cell_count())) return order;
  const std::vector<std::int32_t> faces = faces_to_lag(mesh, direction, passage, walk);
  lagged.assign(passage.size(), 0);
  for (const std::int32_t f : faces) lagged[static_cast<std::size_t>(f)] = 1;
  OrderedWalk again(graph, passage, lagged);
  for (const std::int32_t f : faces)
    order.lagged.push_back(lagged_face(mesh, FaceIndex(f), passage[static_cast<std::size_t>(f)], again));
  again.run(tiles, direction, levels, order);
  return order;
}

}  // namespace etendue
