// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "base/index.h"

namespace etendue {

/// View of values [item][extents...][band], which lie in one array with the band running fastest. Items are
/// cells, faces or other things that are counted.
template <class T, std::size_t... extents>
class FieldView {
  template <std::size_t>
  using Place = std::size_t;

 public:
  FieldView(std::span<T> values, std::size_t bands) : values_(values.data()), bands_(bands) {}

  /// The value of one band.
  T& operator()(std::size_t item, Place<extents>... places, std::size_t band) const {
    return bands_at(item, places...)[band];
  }
  template <class Tag>
  T& operator()(Index<Tag> item, Place<extents>... places, std::size_t band) const {
    return bands_at(item.at(), places...)[band];
  }
  /// Mean of one band over all places of an item: of a function that is linear in a cell or face, the mean
  /// over it.
  template <class Item>
  double mean(Item item, std::size_t band) const {
    constexpr std::size_t places = (extents * ...);
    const T* const first = values_ + position(item) * places * bands_ + band;
    double sum = 0;
    for (std::size_t i = 0; i < places; ++i) sum += first[i * bands_];
    return sum / static_cast<double>(places);
  }

 private:
  static std::size_t position(std::size_t item) { return item; }
  template <class Tag>
  static std::size_t position(Index<Tag> item) {
    return item.at();
  }
  T* bands_at(std::size_t item, Place<extents>... places) const {
    ((item = item * extents + places), ...);
    return values_ + item * bands_;
  }

  T* values_;
  std::size_t bands_;
};

/// Values at the four vertices of each cell, [cell][4][band].
using CellField = FieldView<double, 4>;
using ConstCellField = FieldView<const double, 4>;
/// Vectors at the four vertices of each cell, [cell][4][3][band].
using CellVectors = FieldView<double, 4, 3>;
using ConstCellVectors = FieldView<const double, 4, 3>;
/// Values at the three vertices of each boundary face, [face][3][band].
using FaceField = FieldView<double, 3>;
using ConstFaceField = FieldView<const double, 3>;
/// Values without places, [item][band].
using BandTable = FieldView<double>;
using ConstBandTable = FieldView<const double>;

}  // namespace etendue
