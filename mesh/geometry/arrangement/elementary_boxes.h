// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/geometry/primitives/geometry.h"
#include "mesh/geometry/primitives/wall_naming.h"

namespace etendue {

using GridIndex = std::array<int, 3>;

constexpr GridIndex moved(GridIndex index, int axis, int by) {
  index[static_cast<std::size_t>(axis)] += by;
  return index;
}

/// Whether elementary rectangles hang together as one facet where they may, or each is a facet.
enum class FacetSize { largest, elementary };

/// The planes of all boxes and patches cut space into elementary boxes, each filled by one label.
class ElementaryBoxes {
 public:
  /// All primitives must be boxes. Throws InputError where two planes are too close to be told apart.
  ElementaryBoxes(const Geometry& geometry, const std::vector<SpaceLabel>& labels);
  /// `planes` rise along each axis; a label for each box between them, z fastest.
  ElementaryBoxes(std::array<std::vector<double>, 3> planes, std::vector<SpaceLabel> labels);

  /// Number of elementary boxes along an axis; there is one plane more.
  int count(int axis) const { return static_cast<int>(planes_[static_cast<std::size_t>(axis)].size()) - 1; }
  double plane(int axis, int i) const {
    return planes_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
  }
  /// Outside beyond the outermost planes.
  SpaceLabel label(const GridIndex& box) const { return contains(box) ? labels_[at(box)] : kOutside; }
  bool contains(const GridIndex& box) const;
  std::size_t at(const GridIndex& box) const;  ///< z fastest
  std::size_t size() const { return labels_.size(); }
  Vec3 corner(const GridIndex& node) const;
  Vec3 middle(const GridIndex& box) const;
  double thickness(const GridIndex& box) const;  ///< the shortest edge [length]

 private:
  int plane_index(int axis, double coordinate) const;
  void fill(const BoxPrimitive& box, SpaceLabel label);

  std::array<std::vector<double>, 3> planes_;  ///< [axis] rising
  std::vector<SpaceLabel> labels_;
};

}  // namespace etendue
