// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/angular/media/linear_coefficients.h"
#include "solver/problem/problem.h"

namespace etendue {

/// What light meets in one direction [1/length].
struct PathCoefficients {
  double absorption = 0;
  double scattering = 0;
  double extinction() const { return absorption + scattering; }
};

/// Absorption and scattering as a ray of light sees them: linear in cells where a formula of the place gives
/// them, and in its own direction where they depend on it: leaves, flakes,
/// kernels by formula, and absorption by formula. What a direction meets of a density of 1 is one number for
/// each kind of medium; a formula that depends on the place too is asked in each cell, for its mean there.
/// May be used by several threads at a time.
class RayMatter {
 public:
  /// The problem must outlive it.
  explicit RayMatter(const Problem& problem);
  ~RayMatter();

  /// Returns whether nothing depends on the direction, and nothing varies in cells.
  bool empty() const { return empty_; }
  /// Returns whether coefficients vary in a cell.
  bool varies(CellIndex cell) const { return linear_.varies(cell); }
  /// Returns whether something does in a region.
  bool depends_on_direction(int region) const { return by_direction_[static_cast<std::size_t>(region)] != 0; }

  /// What depends on the direction alone.
  struct View {
    Vec3 travel;                          ///< unit
    std::vector<PathCoefficients> kinds;  ///< [kind] for a density of 1
    std::vector<double> absorption;       ///< [formula] that does not depend on the place
  };
  View view(const Vec3& travel) const;
  /// In the mean over a cell, without a view: for light that asks once in each direction.
  PathCoefficients along(CellIndex cell, std::size_t band, const Vec3& travel) const;
  /// In the mean over a cell.
  PathCoefficients at(CellIndex cell, std::size_t band, const View& view) const;
  /// At a point of it.
  PathCoefficients at(CellIndex cell, std::size_t band, const View& view, const Vec3& point) const;

  /// Adds the extinction at a point times a length, in all bands, to optical depths [band].
  void add_depth(CellIndex cell, const View& view, const Vec3& point, double length,
                 std::span<double> depth) const;

  /// Scattering of each kind of medium, once.
  std::size_t kind_count() const { return kinds_.size(); }
  const DirectionalScattering& scattering(int kind) const;
  /// Which of them a region and band have; -1: none.
  int kind_of(int region, std::size_t band) const {
    return entries_[static_cast<std::size_t>(region) * bands_ + band].kind;
  }

 private:
  struct Kind;
  struct Formula;
  struct Entry {
    int kind = -1;
    int formula = -1;
    bool is_extinction = false;  ///< the formula, of which scattering is a part
  };
  int number_of(const DirectionalScattering& scattering);

  const Problem& problem_;
  std::size_t bands_;
  PathCoefficients turned(PathCoefficients here, CellIndex cell, std::size_t band, const View& view) const;
  /// Coefficients of a cell whose kind of medium is `unit` for a density of 1, and whose formula `value`.
  PathCoefficients composed(PathCoefficients here, const Entry& entry, const PathCoefficients& unit,
                            double value) const;

  LinearCoefficients linear_;
  bool empty_ = true;
  std::vector<char> by_direction_;  ///< [region]
  std::vector<Entry> entries_;      ///< [region][band]
  std::vector<std::unique_ptr<Kind>> kinds_;
  std::vector<std::unique_ptr<Formula>> formulas_;
};

/// Why rays do not know what a medium does to light of directions that are no ordinates; empty where they do.
std::string reason_unseen(const Problem& problem, int region);

}  // namespace etendue
