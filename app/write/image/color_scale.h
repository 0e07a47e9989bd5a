// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace etendue {

/// A scale of numbers, linear or logarithmic, for false colors.
class ColorScale {
 public:
  /// `least` is below `most`, and above 0 where the scale is logarithmic.
  ColorScale(double least, double most, bool logarithmic);

  /// 0 at the lower end, 1 at the upper; below 0 and above 1 beyond them, and on a logarithmic scale minus
  /// infinity for what is not positive.
  double place_of(double value) const;

  struct Tick {
    double place;       ///< from 0 to 1
    std::string label;  ///< the number
  };
  /// Round numbers, eleven at most: on a linear scale steps of 1, 2 or 5 of a power of ten; on a
  /// logarithmic one powers of ten with 2 and 5 times them where there is room for them, or single powers.
  std::vector<Tick> ticks() const;

 private:
  std::vector<Tick> linear_ticks() const;
  std::vector<Tick> logarithmic_ticks() const;

  double least_, most_;
  bool logarithmic_;
};

}  // namespace etendue
