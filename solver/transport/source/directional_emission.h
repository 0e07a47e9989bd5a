// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/angular_input.h"
#include "solver/solution/solution.h"

namespace etendue {

/// Emission q(x, w) of media and radiance L(x, w) of walls that depend on the direction, by their values at
/// the vertices; linear between. What a problem emits alike in all directions is not in it.
class DirectionalEmission : public AngularInput {
 public:
  /// The arguments must outlive it. `other` is added where it is not null. Throws InputError, naming the
  /// medium or wall, the point and the direction, where a value is negative or not finite.
  DirectionalEmission(const Problem& problem, const DirectionSet& directions, const AngularInput* other);

  bool empty() const { return tables_.empty(); }
  bool depends_on_direction(CellIndex cell) const override;
  void add_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override;
  void add_projected_source(OrdinateIndex m, CellIndex cell, std::span<double> values) const override {
    if (other_ != nullptr) other_->add_projected_source(m, cell, values);
  }
  void add_inflow(OrdinateIndex m, FaceIndex face, std::span<double> values) const override;
  const SavedState* prescribed_state() const override {
    return other_ != nullptr ? other_->prescribed_state() : nullptr;
  }

  /// As the discretisation sees them, on the discrete half ranges.
  DirectionalPowers powers() const;

  /// Whether the medium of a region emits so.
  static bool emits(const Medium& medium);
  /// Doubles of the tables.
  static double table_size(const Problem& problem, const DirectionSet& directions);

 private:
  struct Table {
    int band = 0;
    std::vector<double> values;  ///< [ordinate][row]
  };
  /// The tables of one region or wall.
  struct Emitter {
    std::vector<std::int32_t> row;  ///< [vertex], -1 where it is not one of the region's or wall's
    std::size_t rows = 0;
    std::vector<std::size_t> tables;
  };
  void add_tables(const std::vector<std::optional<AngularFormula>>& formulas, Emitter& emitter);
  void check_regions() const;
  void check_walls() const;
  void add(const Emitter& emitter, OrdinateIndex m, std::span<const std::int32_t> vertices,
           std::span<double> values) const;

  const Problem& problem_;
  const DirectionSet& directions_;
  const AngularInput* other_;
  std::vector<Table> tables_;
  std::vector<Emitter> regions_;  ///< [region]
  std::vector<Emitter> walls_;    ///< [wall]
};

}  // namespace etendue
