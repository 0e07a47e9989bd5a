// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/expression/expression.h"
#include "base/vec3.h"

namespace etendue {

/// A formula in the place x, y, z and the direction of travel wx, wy, wz. Copies are independent; one object
/// must not be evaluated by two threads at a time.
class AngularFormula {
 public:
  /// Throws InputError (without a file) where the text is not a formula in these.
  explicit AngularFormula(Formula formula);

  double at(const Vec3& point, const Vec3& direction) const;
  /// The same with the direction reversed: at(point, -direction) of this one.
  AngularFormula reversed() const;
  /// Returns whether it uses wx, wy or wz.
  bool depends_on_direction() const;
  /// Returns whether it uses x, y or z.
  bool depends_on_place() const;
  const std::string& text() const { return formula_.text(); }

 private:
  Expression formula_;
  double sign_ = 1;  ///< of the direction
};

/// x, y, z, wx, wy, wz
const std::vector<std::string>& angular_variables();

/// Returns whether a text is a formula in these that uses wx, wy or wz.
bool depends_on_direction(const Formula& formula);

/// The formula's mean over all directions as a formula in x, y, z: the rule of degree 5 on the axes and
/// diagonals (Lebedev 1976), in the plane eight directions.
Formula mean_over_directions(const Formula& formula, bool in_plane);

}  // namespace etendue
