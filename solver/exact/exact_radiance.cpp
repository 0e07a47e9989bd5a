// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/exact/exact_radiance.h"

#include <array>

namespace etendue {

ExactRadiance::ExactRadiance(const std::string& formula)
    : formula_(formula, {"x", "y", "z", "wx", "wy", "wz"}) {}

double ExactRadiance::at(const Vec3& point, const Vec3& direction) const {
  const std::array<double, 6> values = {point.x(),     point.y(),     point.z(),
                                        direction.x(), direction.y(), direction.z()};
  return formula_(std::span<const double>(values));
}

Dual ExactRadiance::with_gradient(const Vec3& point, const Vec3& direction) const {
  const std::array<Dual, 6> values = {Dual{point.x(), Vec3::UnitX()},
                                      Dual{point.y(), Vec3::UnitY()},
                                      Dual{point.z(), Vec3::UnitZ()},
                                      Dual{direction.x()},
                                      Dual{direction.y()},
                                      Dual{direction.z()}};
  return formula_(std::span<const Dual>(values));
}

}  // namespace etendue
