// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>

#include "base/vec3.h"
#include "solver/materials/surfaces/albedo_table.h"

namespace etendue {

/// A direction that light is reflected into. In the frame where the normal, on the side of the light, is z
/// and the light comes from (sin, 0, cos).
struct ReflectedRay {
  Vec3 direction;
  double weight;  ///< f_r cos / density of the direction; 0 where it points below the surface
};

/// A reflectance f_r(w_i -> w_o) [1/sr] of a surface without a grain (Nicodemus et al. 1977): reflected light
/// is the integral of f_r L cos over the light that arrives. Reciprocal: f_r(w_i -> w_o) = f_r(w_o -> w_i).
/// Without a grain it depends on three cosines alone: those between the normal and the directions i to the
/// light and o of the reflected light, and the one between i and o.
class Reflectance {
 public:
  virtual ~Reflectance() = default;

  /// f_r [1/sr]; the cosines with the normal are above 0.
  virtual double value(double cos_in, double cos_out, double between) const = 0;
  /// A direction by two numbers that are uniform on [0, 1).
  virtual ReflectedRay sample(double cos_in, double u, double v) const = 0;

  /// The radius of a cone with the solid angle that the lobe would have if it were even [radian], of light
  /// along the normal: sqrt(albedo / (pi f_r)) at its peak.
  double width() const;

  /// What is reflected in all directions, of light from one: the integral of f_r cos.
  double albedo(double cos_in) const { return albedo_.at(cos_in); }
  const AlbedoTable& albedo() const { return albedo_; }

  /// f_r of light that travels along `in` into the direction `out`, at a surface with this unit normal on the
  /// side of the light; 0 where one of them lies on the other side.
  double between(const Vec3& in, const Vec3& out, const Vec3& normal) const {
    const double cos_in = -in.dot(normal), cos_out = out.dot(normal);
    return cos_in > 0 && cos_out > 0 ? value(cos_in, cos_out, -in.dot(out)) : 0;
  }

 protected:
  Reflectance() = default;
  Reflectance(const Reflectance&) = default;
  Reflectance& operator=(const Reflectance&) = default;
  /// What every model ends its construction with.
  void set_albedo(AlbedoTable table) { albedo_ = std::move(table); }

 private:
  AlbedoTable albedo_;
};

/// A direction of that frame in space: light comes from the unit vector `light`, and `normal` is on its side.
inline Vec3 from_frame(const Vec3& direction, const Vec3& light, const Vec3& normal) {
  const Vec3 slant = light - light.dot(normal) * normal;
  // Along the normal all azimuths are alike.
  constexpr double upright = 1e-9;
  const Vec3 along = slant.norm() > upright ? slant.normalized() : Vec3(normal.unitOrthogonal());
  return (direction.x() * along + direction.y() * normal.cross(along) + direction.z() * normal).normalized();
}

/// The cosine of the angle between the mirrored direction of i and o.
inline double cosine_off_mirror(double cos_in, double cos_out, double between) {
  return 2 * cos_in * cos_out - between;
}

}  // namespace etendue
