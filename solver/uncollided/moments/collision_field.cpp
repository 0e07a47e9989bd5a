// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/moments/collision_field.h"

#include <algorithm>
#include <cmath>

#include "solver/uncollided/sources/beam_source.h"
#include "solver/uncollided/sources/wide_source.h"

namespace etendue {
namespace {

/// Part of all that scatters in a cell below which a direction is left out: it scatters isotropically.
constexpr double negligible_scattering = 1e-9;

/// [band] the sum over directions of the largest absolute values.
std::vector<double> sizes_of(const DirectionalMoments& moments) {
  std::vector<double> sizes(moments.bands(), 0);
  for (std::size_t k = 0; k < moments.found().size(); ++k) {
    const std::span<const double> values = moments.values(k);
    for (std::size_t i = 0; i < values.size(); ++i) sizes[i % sizes.size()] += std::abs(values[i]);
  }
  return sizes;
}

bool is_trifle(std::span<const double> values, const std::vector<double>& sizes) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i]) > negligible_scattering * sizes[i % sizes.size()]) return false;
  return true;
}

}  // namespace

// The inverse of the mass matrix makes nodal values of integrals (NodalMoments::nodal).
void CollisionField::add(CellIndex cell, double volume, const DirectionalMoments& moments) {
  const std::vector<double> sizes = sizes_of(moments);
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < moments.found().size(); ++k)
    if (!is_trifle(moments.values(k), sizes)) order.push_back(k);
  std::ranges::sort(order, {}, [&](std::size_t k) { return moments.found()[k]; });
  Cell sum, &old = cells_[cell.at()];
  const auto copy_old = [&](std::size_t k) {
    sum.direction.push_back(old.direction[k]);
    const auto from = old.values.begin() + static_cast<std::ptrdiff_t>(k * 4 * bands_);
    sum.values.insert(sum.values.end(), from, from + static_cast<std::ptrdiff_t>(4 * bands_));
  };
  std::size_t next = 0;
  for (const std::size_t k : order) {
    const std::int32_t direction = moments.found()[k];
    while (next < old.direction.size() && old.direction[next] < direction) copy_old(next++);
    if (next < old.direction.size() && old.direction[next] == direction) {
      copy_old(next++);
    } else {
      sum.direction.push_back(direction);
      sum.values.resize(sum.values.size() + 4 * bands_, 0);
    }
    double* to = sum.values.data() + sum.values.size() - 4 * bands_;
    const std::span<const double> integrals = moments.values(k);
    for (std::size_t b = 0; b < bands_; ++b) {
      double total = 0;
      for (std::size_t i = 0; i < 4; ++i) total += integrals[i * bands_ + b];
      for (std::size_t i = 0; i < 4; ++i)
        to[i * bands_ + b] += 4 / volume * (5 * integrals[i * bands_ + b] - total);
    }
  }
  while (next < old.direction.size()) copy_old(next++);
  sum.direction.shrink_to_fit();
  sum.values.shrink_to_fit();
  old = std::move(sum);
}

// Of each cell: its number, the number of its directions, their numbers and the values.
void CollisionField::share(RankGroup& ranks) {
  if (empty()) return;
  std::vector<double> own;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Cell& cell = cells_[c];
    if (cell.direction.empty()) continue;
    own.push_back(static_cast<double>(c));
    own.push_back(static_cast<double>(cell.direction.size()));
    own.insert(own.end(), cell.direction.begin(), cell.direction.end());
    own.insert(own.end(), cell.values.begin(), cell.values.end());
  }
  for (int rank = 0; rank < ranks.count(); ++rank) {
    const bool is_own = rank == ranks.rank();
    double size = static_cast<double>(own.size());
    ranks.bring({&size, 1}, rank);
    std::vector<double> brought(is_own ? 0 : static_cast<std::size_t>(size));
    ranks.bring(is_own ? own : brought, rank);
    for (auto at = brought.begin(); at != brought.end();) {
      Cell& cell = cells_[static_cast<std::size_t>(*at++)];
      const auto count = static_cast<std::size_t>(*at++);
      for (std::size_t k = 0; k < count; ++k) cell.direction.push_back(static_cast<std::int32_t>(*at++));
      const auto end = at + static_cast<std::ptrdiff_t>(count * 4 * bands_);
      cell.values.assign(at, end);
      at = end;
    }
  }
}

CollisionField CollisionField::with_bands(std::size_t bands) const {
  CollisionField other(directions_, cells_.size(), bands);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    other.cells_[c].direction = cells_[c].direction;
    other.cells_[c].values.assign(cells_[c].direction.size() * 4 * bands, 0);
  }
  return other;
}

// A point comes to a cell from some twelve directions of the grid, the sun from one; the light of a lamp, a
// wall or a medium from as many as it seems wide, a sky from half of the coarse grid.
CollisionField::Size CollisionField::estimate(const LightPaths& paths, const LightSources& sources) {
  constexpr std::size_t of_point = 12, of_extended = 60, of_sky = 150, overhead = 6;
  const Problem& problem = paths.problem();
  const PhaseList phases(problem);
  std::size_t cells = 0;
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c)
    if (scatters_by_direction(problem, phases, paths.matter(), CellIndex(c))) ++cells;
  if (cells == 0) return {0, 0};
  std::size_t directions = 0;
  bool only_beams = true;
  for (const auto& source : sources) {
    if (const BeamSource* beam = source->as_beam()) {
      directions += beam->directions().size();
      continue;
    }
    only_beams = false;
    directions += source->as_wide() == nullptr             ? of_point
                  : source->as_wide()->as_sky() != nullptr ? of_sky
                                                           : of_extended;
  }
  const std::size_t in_use = only_beams ? directions : IncidentDirections(problem, {}).size();
  return {in_use, cells * directions * (sizeof(double) * (4 * paths.bands() + 1)) +
                      cells * overhead * sizeof(double)};
}

bool scatters_by_direction(const Problem& problem, const PhaseList& phases, const RayMatter& matter,
                           CellIndex cell) {
  const int region = problem.mesh().region(cell);
  for (int b = 0; b < problem.band_count(); ++b) {
    const auto band = static_cast<std::size_t>(b);
    if (problem.scattering(cell, b) > 0 &&
        (matter.kind_of(region, band) >= 0 || phases.of(region, band) >= 0))
      return true;
  }
  return false;
}

}  // namespace etendue
