// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/transport/kernel/sweep_visit.h"

namespace etendue {

/// The slots that mean the same for every direction: 0 for the idle cell and for faces through which nothing
/// passes, one for each boundary face (its inflow), and one for each cell at the boundary, whose radiance the
/// walls read when the sweep is done.
class WallSlots {
 public:
  explicit WallSlots(const TetrahedralMesh& mesh);

  std::uint32_t inflow(std::int32_t boundary_face) const {
    return 1 + static_cast<std::uint32_t>(boundary_face);
  }
  /// The boundary face as the cell inside sees it.
  FaceCode inside(std::int32_t boundary_face) const {
    return inside_[static_cast<std::size_t>(boundary_face)];
  }
  /// 0 for cells without a boundary face.
  std::uint32_t of_cell(std::int32_t cell) const { return of_cell_[static_cast<std::size_t>(cell)]; }
  std::span<const std::uint32_t> of_cells() const { return of_cell_; }
  /// The first slot that is free for other uses.
  std::uint32_t count() const { return count_; }

 private:
  std::vector<std::uint32_t> of_cell_;
  std::vector<FaceCode> inside_;
  std::uint32_t count_ = 0;
};

/// Node of a cell that lies opposite one of its faces.
std::uint32_t opposite_node(const TetrahedralMesh& mesh, CellIndex cell, FaceIndex face);

/// The slots of one thread: radiance [slot][node][stride] [power/(length^2 sr)].
template <class Real>
struct SweepSlotsOf {
  Real* radiance = nullptr;
  std::size_t cell_length = 0;  ///< nodes times stride
  std::size_t stride = 1;

  Real* slot(std::uint32_t s) const { return radiance + s * cell_length; }
  /// [stride] at vertex k (0, 1, 2) of a face; constants have one value.
  Real* face_node(FaceCode face, std::size_t k) const {
    return slot(face.slot) +
           (cell_length == stride ? 0 : etendue::face_node(face.opposite, static_cast<std::uint32_t>(k))) *
               stride;
  }
};

using SweepSlots = SweepSlotsOf<double>;

}  // namespace etendue
