// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/box_grid.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// A grid cell for each box is about what makes filling and asking equally cheap.
constexpr double kGridCellsPerBox = 1.0;
constexpr int kMostCellsPerAxis = 1024;

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
  const Vec3 size = thickened(bounds_.sizes());
  const double spacing = std::cbrt(size.prod() / (kGridCellsPerBox * static_cast<double>(grown.size())));
  for (int axis = 0; axis < 3; ++axis) {
    counts_[axis] = static_cast<int>(std::clamp(size[axis] / spacing, 1.0, double{kMostCellsPerAxis}));
    per_length_[axis] = counts_[axis] / size[axis];
  }

  // Counts first, then the items in place: boxes stay in rising order within each grid cell.
  const auto for_each_cell = [&](const Box& box, const auto& use) {
    const Cell low = cell_of(box.min());
    const Cell high = cell_of(box.max());
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i) use(index(i, j, k));
  };
  first_.assign(static_cast<std::size_t>(counts_.prod()) + 1, 0);
  for (const Box& box : grown) for_each_cell(box, [&](std::size_t cell) { ++first_[cell + 1]; });
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  items_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t b = 0; b < grown.size(); ++b)
    for_each_cell(grown[b], [&](std::size_t cell) {
      items_[static_cast<std::size_t>(next[cell]++)] = static_cast<std::int32_t>(b);
    });
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
  const Cell cell = cell_of(point);
  const std::size_t at = index(cell.x(), cell.y(), cell.z());
  return std::span(items_).subspan(static_cast<std::size_t>(first_[at]),
                                   static_cast<std::size_t>(first_[at + 1] - first_[at]));
}

}  // namespace etendue
