// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "base/parallel/copy_pool.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"

namespace etendue {

/// Emission q(x, w) of a region or radiance L(x, w) of a wall in one band that a formula gives: its values at
/// vertices, linear between, as the other methods take it. May be used by several threads at a time.
class FormulaEmitter {
 public:
  /// What a vertex sends.
  struct Node {
    /// Of q over all directions [power/length^3], or of L w.n over those into the domain [power/length^2].
    double integral = 0;
    double largest = 0;  ///< bound of the values in these directions
  };
  /// The problem must outlive it.
  FormulaEmitter(const Problem& problem, const AngularFormula& formula) : problem_(problem), pool_(formula) {}
  /// Fills the nodes of a region's cells, or of a wall's faces.
  void look_at_region(int region);
  void look_at_wall(int wall);

  double at(const Vec3& point, const Vec3& travel) const;
  /// Of corner `i` of a cell or a face.
  const Node& node(CellIndex cell, std::size_t i) const { return nodes_[row_[4 * cell.at() + i]]; }
  const Node& node(FaceIndex face, std::size_t i) const { return nodes_[row_[3 * face.at() + i]]; }
  double at_corner(CellIndex cell, std::size_t i, const Vec3& travel) const;
  double at_corner(FaceIndex face, std::size_t i, const Vec3& travel) const;

 private:
  /// A vertex, and the normal into the domain of a wall or zero.
  struct Place {
    std::int32_t vertex;
    Vec3 normal;
  };
  void fill(const std::vector<Place>& places);
  Node sent_from(const Place& place) const;
  Node in_plane(const Place& place) const;

  const Problem& problem_;
  mutable CopyPool<AngularFormula> pool_;
  std::vector<std::size_t> row_;  ///< [cell][4] or [boundary face][3] of a node
  std::vector<Node> nodes_;
};

/// All of them in a problem.
class FormulaEmission {
 public:
  /// The problem must outlive it. Throws InputError as DirectionalEmission does, in the directions of a small
  /// set.
  explicit FormulaEmission(const Problem& problem);

  bool empty() const { return regions_.empty() && walls_.empty(); }
  /// Null where there is none.
  const FormulaEmitter* of_region(int region, int band) const { return entry(regions_, region, band); }
  const FormulaEmitter* of_wall(int wall, int band) const { return entry(walls_, wall, band); }
  /// Adds to a solution what walls emit so to the exitance, and the powers; once.
  void add_to(Solution& fields) const;

 private:
  using Emitters = std::vector<std::unique_ptr<const FormulaEmitter>>;
  const FormulaEmitter* entry(const Emitters& list, int number, int band) const {
    return list.empty() ? nullptr : list[static_cast<std::size_t>(number * bands_ + band)].get();
  }

  const Problem& problem_;
  int bands_;
  Emitters regions_;  ///< [region][band]; empty: none
  Emitters walls_;    ///< [wall][band]; empty: none
};

}  // namespace etendue
