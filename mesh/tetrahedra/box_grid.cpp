// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/box_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace etendue {
namespace {

/// A grid cell for each box is about what makes filling and asking equally cheap.
constexpr double kGridCellsPerBox = 1.0;
constexpr int kMostCellsPerAxis = 1024;
/// So many boxes of a grid cell get a grid of their own; cells of an even mesh have fewer.
constexpr std::size_t kCrowd = 128;
/// Grid cells of a box, on average, from which on a finer grid would not part the boxes; and in all finer
/// grids for each box that there is.
constexpr std::size_t kMostCopies = 8, kMostCopiesInAll = 64;
constexpr int kMostDepth = 8;

/// Flat domains keep a third dimension, so that a grid cell has a volume.
Vec3 thickened(const Vec3& size) {
  const double longest = size.maxCoeff();
  return longest > 0 ? Vec3(size.cwiseMax(1e-3 * longest)) : Vec3::Ones();
}

}  // namespace

BoxGrid::BoxGrid(std::span<const Box> boxes, double margin) {
  std::vector<Box> grown(boxes.begin(), boxes.end());
  for (Box& box : grown) {
    box.min().array() -= margin;
    box.max().array() += margin;
    bounds_.extend(box);
  }
  if (grown.empty()) {
    first_ = {0, 0};
    return;
  }
  std::vector<std::int32_t> all(grown.size());
  std::iota(all.begin(), all.end(), 0);
  set_cells(all.size());
  fill(grown, all);
  std::size_t room = kMostCopiesInAll * all.size();
  divide_crowded_cells(grown, 0, room);
}

void BoxGrid::set_cells(std::size_t boxes) {
  const Vec3 size = thickened(bounds_.sizes());
  const double spacing = std::cbrt(size.prod() / (kGridCellsPerBox * static_cast<double>(boxes)));
  for (int axis = 0; axis < 3; ++axis) {
    counts_[axis] = static_cast<int>(std::clamp(size[axis] / spacing, 1.0, double{kMostCellsPerAxis}));
    per_length_[axis] = counts_[axis] / size[axis];
  }
}

std::size_t BoxGrid::copies(std::span<const Box> all, std::span<const std::int32_t> boxes) const {
  std::size_t sum = 0;
  for (const std::int32_t box : boxes) {
    const Box& of = all[static_cast<std::size_t>(box)];
    sum += static_cast<std::size_t>((cell_of(of.max()) - cell_of(of.min()) + Cell::Ones()).prod());
  }
  return sum;
}

void BoxGrid::fill(std::span<const Box> all, std::span<const std::int32_t> boxes) {
  // Counts first, then the items in place: boxes stay in rising order within each grid cell.
  const auto for_each_cell = [&](const Box& box, const auto& use) {
    const Cell low = cell_of(box.min());
    const Cell high = cell_of(box.max());
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i) use(index(i, j, k));
  };
  first_.assign(static_cast<std::size_t>(counts_.prod()) + 1, 0);
  for (const std::int32_t box : boxes)
    for_each_cell(all[static_cast<std::size_t>(box)], [&](std::size_t cell) { ++first_[cell + 1]; });
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  items_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  for (const std::int32_t box : boxes)
    for_each_cell(all[static_cast<std::size_t>(box)],
                  [&](std::size_t cell) { items_[static_cast<std::size_t>(next[cell]++)] = box; });
}

void BoxGrid::divide_crowded_cells(std::span<const Box> all, int depth, std::size_t& room) {
  if (depth == kMostDepth) return;
  for (int k = 0; k < counts_.z(); ++k)
    for (int j = 0; j < counts_.y(); ++j)
      for (int i = 0; i < counts_.x(); ++i) {
        const std::size_t at = index(i, j, k);
        const std::span<const std::int32_t> crowd = items(at);
        if (crowd.size() <= kCrowd) continue;
        BoxGrid finer;
        finer.bounds_ = box_of({i, j, k});
        finer.set_cells(crowd.size());
        // Where the boxes overlap in one place more cells do not part them.
        const std::size_t needed = finer.copies(all, crowd);
        if (needed > std::min(room, kMostCopies * crowd.size())) continue;
        room -= needed;
        finer.fill(all, crowd);
        finer.divide_crowded_cells(all, depth + 1, room);
        crowded_.push_back(at);
        finer_.push_back(std::move(finer));
      }
}

Box BoxGrid::box_of(const Cell& cell) const {
  const Vec3 low = bounds_.min() + cell.cast<double>().cwiseQuotient(per_length_);
  return {low, low + per_length_.cwiseInverse()};
}

std::span<const std::int32_t> BoxGrid::items(std::size_t cell) const {
  return std::span(items_).subspan(static_cast<std::size_t>(first_[cell]),
                                   static_cast<std::size_t>(first_[cell + 1] - first_[cell]));
}

BoxGrid::Cell BoxGrid::cell_of(const Vec3& point) const {
  const Vec3 place = (point - bounds_.min()).cwiseProduct(per_length_);
  Cell cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[axis] = static_cast<int>(std::clamp(place[axis], 0.0, counts_[axis] - 1.0));
  return cell;
}

std::size_t BoxGrid::index(int i, int j, int k) const {
  return static_cast<std::size_t>((k * counts_.y() + j) * counts_.x() + i);
}

std::span<const std::int32_t> BoxGrid::candidates(const Vec3& point) const {
  if (!bounds_.contains(point)) return {};
  for (const BoxGrid* grid = this;;) {
    const Cell cell = grid->cell_of(point);
    const std::size_t at = grid->index(cell.x(), cell.y(), cell.z());
    const auto crowded = std::lower_bound(grid->crowded_.begin(), grid->crowded_.end(), at);
    if (crowded == grid->crowded_.end() || *crowded != at) return grid->items(at);
    grid = &grid->finer_[static_cast<std::size_t>(crowded - grid->crowded_.begin())];
  }
}

}  // namespace etendue
