// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "base/parallel/rank_group.h"
#include "solver/angular/media/ray_matter.h"
#include "solver/problem/phase_list.h"
#include "solver/uncollided/moments/directional_moments.h"

namespace etendue {

/// First collisions in cells whose medium scatters by direction: for each cell the directions from which the
/// light comes, and the power density that scatters of each, projected on the linear functions of the cell.
/// The power by direction sums up to all that scatters but for a part that is to be scattered isotropically:
///
///     s(w) = c / (4 pi) + sum over v of c_v (P_v(w) - 1 / (4 pi)),
///
/// P_v being the distribution, of integral 1, of what scatters of the direction v, and c the nodal values of
/// all that scatters. So power is kept whatever the c_v are, and the net flux too, since the weights of
/// IncidentDirections keep that of the light.
class CollisionField {
 public:
  CollisionField() = default;
  CollisionField(std::shared_ptr<const IncidentDirections> directions, std::size_t cells, std::size_t bands)
      : directions_(std::move(directions)), bands_(bands), cells_(cells) {}

  /// Empty where nothing scatters by direction.
  bool empty() const { return cells_.empty(); }
  const IncidentDirections& directions() const { return *directions_; }
  std::shared_ptr<const IncidentDirections> shared_directions() const { return directions_; }
  /// Adds the integrals over a cell. Threads may add to different cells at a time.
  void add(CellIndex cell, double volume, const DirectionalMoments& moments);
  /// Brings the cells that each rank has added to, and no other one has, to all.
  void share(RankGroup& ranks);

  /// Of a cell: numbers of directions, ascending.
  std::span<const std::int32_t> directions_at(CellIndex cell) const { return cells_[cell.at()].direction; }
  /// Of the k-th of them: nodal values [4][band] [power/length^3].
  std::span<const double> values(CellIndex cell, std::size_t k) const {
    return std::span(cells_[cell.at()].values).subspan(k * 4 * bands_, 4 * bands_);
  }
  std::span<double> values(CellIndex cell, std::size_t k) {
    return std::span(cells_[cell.at()].values).subspan(k * 4 * bands_, 4 * bands_);
  }
  /// The same directions in the same cells, with as many values of other bands, all 0.
  CollisionField with_bands(std::size_t bands) const;
  /// Makes all values 0.
  void clear_values() {
    for (Cell& cell : cells_) std::ranges::fill(cell.values, 0.0);
  }
  /// Upper estimate for lights of a problem.
  struct Size {
    std::size_t directions;  ///< in use
    std::size_t bytes;
  };
  static Size estimate(const LightPaths& paths, const LightSources& sources);

 private:
  struct Cell {
    std::vector<std::int32_t> direction;
    std::vector<double> values;  ///< [direction][4][band]
  };
  std::shared_ptr<const IncidentDirections> directions_;
  std::size_t bands_ = 0;
  std::vector<Cell> cells_;
};

/// Returns whether what scatters in a cell goes into other directions when it comes from others, in any band.
bool scatters_by_direction(const Problem& problem, const PhaseList& phases, const RayMatter& matter,
                           CellIndex cell);

}  // namespace etendue
