// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/sweep_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>

#include "solver/transport/order/cycle_breaking.h"
#include "solver/transport/order/projected_area.h"
#include "solver/transport/order/ready_cells.h"

namespace etendue {
namespace {

constexpr std::uint32_t all_faces = 0xf;

/// Cells of the largest packet that a kernel works on.
constexpr std::size_t largest_packet = 8;

/// Which way light passes through a face: from its owner, into its owner, or not at all.
enum class Passage : signed char { into_owner = -1, none = 0, from_owner = 1 };

void find_passages(const TetrahedralMesh& mesh, const Vec3& direction, std::vector<Passage>& result) {
  result.resize(static_cast<std::size_t>(mesh.face_count()));
  const auto normals = mesh.face_area_normals();
  for (std::size_t f = 0; f < result.size(); ++f) {
    const double a = projected_area(normals[f], direction);
    result[f] = static_cast<Passage>((a > 0) - (a < 0));
  }
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
  OrderedWalk(const SweepGraph& graph, const SweepTiles& tiles, LevelOrder levels)
      : graph_(graph),
        levels_(levels),
        passage_(graph.cell_count()),
        states_(graph.cell_count()),
        free_(states_.size() + 2),
        done_waiting_(states_.size() + 1),
        ready_(states_.size(), tiles) {}

  /// Before each walk. `lagged` is [face], or empty where none is.
  void prepare(const std::vector<Passage>& passage, const std::vector<char>& lagged) {
    first_recycled_ = graph_.walls().count();
    for (std::size_t c = 0; c < passage_.size(); ++c) {
      const SweepGraph::Faces& faces = graph_.faces()[c];
      std::uint32_t out = 0, none = 0, lag = 0;
      for (unsigned k = 0; k < 4; ++k) {
        const auto face = static_cast<std::size_t>(faces.numbers[k]);
        out |= static_cast<std::uint32_t>(passage[face] == Passage::from_owner) << k;
        none |= static_cast<std::uint32_t>(passage[face] == Passage::none) << k;
        if (!lagged.empty()) lag |= static_cast<std::uint32_t>(lagged[face]) << k;
      }
      // The outflow of the owner is the inflow of the other cell.
      out = (out ^ ~faces.owned) & ~none & all_faces;
      const std::uint32_t passing = ~(none | faces.boundary) & all_faces;
      passage_[c] = {static_cast<std::uint8_t>(out & passing & ~lag), static_cast<std::uint8_t>(none),
                     static_cast<std::uint8_t>(passing), static_cast<std::uint8_t>(out)};
      states_[c] = {graph_.walls().of_cells()[c],
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

  /// `visits` [cells]; fewer of them are used where cycles are left.
  void run(const Vec3& direction, std::span<SweepVisit> visits, SweepOrder& order) {
    order.levels.assign(1, 0);
    order.steps.assign(1, 0);
    // One before the stack and one behind it are read and written where nothing is taken or given back.
    for (std::size_t i = 0; i < states_.size(); ++i)
      free_[1 + i] = first_recycled_ + static_cast<std::uint32_t>(states_.size() - 1 - i);
    free_end_ = free_.data() + 1 + states_.size();
    next_visit_ = visits.data();
    largest_slot_ = first_recycled_ - 1;
    ready_.begin(direction);
    for (std::size_t c = 0; c < states_.size(); ++c)
      if (states_[c].waiting == 0) ready_.add(static_cast<std::uint32_t>(c));
    std::vector<std::uint32_t> level;
    while (ready_.open_next()) {
      for (ready_.move_to(level); !level.empty(); ready_.move_to(level)) {
        // What would not fill the last packet waits for the next level.
        const std::size_t size =
            level.size() < largest_packet ? level.size() : level.size() / largest_packet * largest_packet;
        if (levels_ == LevelOrder::alike) sort_by_passage(std::span(level).first(size));
        visit_level(std::span(level).first(size));
        order.levels.push_back(static_cast<std::int32_t>(next_visit_ - visits.data()));
        level.erase(level.begin(), level.begin() + static_cast<std::ptrdiff_t>(size));
      }
      order.steps.push_back(static_cast<std::int32_t>(order.levels.size()) - 1);
    }
    order.visits = {visits.data(), next_visit_};
    order.slot_count = largest_slot_ + 1;
  }

  bool is_waiting(std::int32_t cell) const { return states_[static_cast<std::size_t>(cell)].waiting > 0; }

 private:
  /// What changes with every visit: in registers, while a level is visited.
  struct Ends {
    std::uint32_t* free_slots;
    std::uint32_t* done_waiting;
    std::uint32_t largest_slot;
  };

  /// Those alike keep their order.
  void sort_by_passage(std::span<std::uint32_t> level) {
    std::array<std::size_t, all_faces + 2> begin{};
    for (const std::uint32_t cell : level) ++begin[passage_[cell].out + std::size_t{1}];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    unsorted_.assign(level.begin(), level.end());
    for (const std::uint32_t cell : unsorted_) level[begin[passage_[cell].out]++] = cell;
  }

  void visit_level(std::span<const std::uint32_t> level) {
    Ends ends{free_end_, done_waiting_.data(), largest_slot_};
    SweepVisit* next = next_visit_;
    for (const std::uint32_t cell : level) visit(cell, *next++, ends);
    next_visit_ = next;
    free_end_ = ends.free_slots;
    largest_slot_ = ends.largest_slot;
    for (const std::uint32_t* cell = done_waiting_.data(); cell != ends.done_waiting; ++cell) {
      __builtin_prefetch(&graph_.behind()[*cell]);
      ready_.add(*cell);
    }
  }

  [[gnu::always_inline]] void visit(std::uint32_t c, SweepVisit& result, Ends& ends) {
    const std::array<std::uint32_t, 4>& behind = graph_.behind()[c].faces;
    const CellPassage passage = passage_[c];
    result.cell_and_parallel = c | static_cast<std::uint32_t>(passage.parallel) << visit_cell_bits;
    result.slot = take(states_[c], ends);
    ends.largest_slot = std::max(ends.largest_slot, result.slot);
    for (unsigned k = 0; k < 4; ++k) {
      result.faces[k] = 0;
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
  LevelOrder levels_;
  std::vector<CellPassage> passage_;
  std::vector<State> states_;  ///< [cell]
  std::uint32_t first_recycled_ = 0;
  std::uint32_t largest_slot_ = 0;
  std::vector<std::uint32_t> free_;  ///< a stack: slots given back above those never taken
  std::uint32_t* free_end_ = nullptr;
  std::vector<std::uint32_t> done_waiting_;  ///< scratch: what becomes ready in one level
  std::vector<std::uint32_t> unsorted_;      ///< scratch: a level
  SweepVisit* next_visit_ = nullptr;         ///< those before are done
  ReadyCells ready_;
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

struct SweepOrderMaker::Memory {
  OrderedWalk walk;
  std::vector<Passage> passage;  ///< [face]
};

SweepOrderMaker::SweepOrderMaker(const SweepGraph& graph, const SweepTiles& tiles, LevelOrder levels)
    : mesh_(graph.mesh()), memory_(new Memory{OrderedWalk(graph, tiles, levels), {}}) {}

SweepOrderMaker::~SweepOrderMaker() = default;

SweepOrder SweepOrderMaker::make(const Vec3& direction, std::span<SweepVisit> visits) {
  OrderedWalk& walk = memory_->walk;
  std::vector<Passage>& passage = memory_->passage;
  find_passages(mesh_, direction, passage);
  SweepOrder order;
  std::vector<char> lagged;
  walk.prepare(passage, lagged);
  walk.run(direction, visits, order);
  if (order.visits.size() == static_cast<std::size_t>(mesh_.cell_count())) return order;
  const std::vector<std::int32_t> faces = faces_to_lag(mesh_, direction, passage, walk);
  lagged.assign(passage.size(), 0);
  for (const std::int32_t f : faces) lagged[static_cast<std::size_t>(f)] = 1;
  walk.prepare(passage, lagged);
  for (const std::int32_t f : faces)
    order.lagged.push_back(lagged_face(mesh_, FaceIndex(f), passage[static_cast<std::size_t>(f)], walk));
  walk.run(direction, visits, order);
  return order;
}

}  // namespace etendue
