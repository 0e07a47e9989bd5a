// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/angular_space.h"
#include "base/index.h"
#include "base/vec3.h"
#include "solver/angular/sets/rotation.h"

namespace etendue {

/// Directions in which light travels, and the solid angle of each. Weights sum to 4 pi (in the plane: angles
/// that sum to 2 pi, and every direction has z = 0), the opposite of every direction is in the set, and the
/// directions are in pairs: 2k and 2k+1 are opposite. Consecutive pairs are close in angle, octant by
/// octant.
class DirectionSet {
 public:
  /// Unit directions and weights [sr] in any order. Weights are scaled by a factor within 1e-12 of 1 to sum
  /// to the full range. Throws std::invalid_argument where an opposite is missing, the sum is off or a
  /// direction leaves the plane.
  DirectionSet(std::string name, int order, const std::vector<Vec3>& directions,
               const std::vector<double>& weights, AngularSpace space = AngularSpace::sphere);

  const std::string& name() const { return name_; }
  int order() const { return order_; }
  AngularSpace space() const { return space_; }
  int count() const { return static_cast<int>(directions_.size()); }
  const Vec3& direction(OrdinateIndex m) const { return directions_[m.at()]; }
  double weight(OrdinateIndex m) const { return weights_[m.at()]; }  ///< [sr]
  std::span<const Vec3> directions() const { return directions_; }
  std::span<const double> weights() const { return weights_; }

  /// The ordinate that `m` becomes at a mirror with this unit normal, to within 1e-12; -1 where it is not in
  /// the set or has another weight.
  int mirrored(OrdinateIndex m, const Vec3& normal) const;

  /// Discrete half range: the sum of w |w.n| over the directions with w.n < 0 [sr]; pi in the limit,
  /// or 2 in the plane.
  double half_range(const Vec3& normal) const;

 private:
  std::string name_;
  int order_;
  AngularSpace space_;
  std::vector<Vec3> directions_;
  std::vector<double> weights_;
  std::vector<std::int32_t> by_x_;  ///< ordinates by rising x, to find one by its direction
};

/// Gauss-Legendre levels of the cosine about z, `order` of them (even), times 2 order azimuths at half steps.
DirectionSet directions_product(int order);
/// As the product, but with 4, 8, 12 … azimuths from the pole to the equator: order (order + 2) directions.
DirectionSet directions_triangular(int order);
/// `order` Gauss-Legendre levels of the cosine about z on each of [-1, 0] and [0, 1] (2 or more), times
/// 4 order azimuths at half steps: half ranges along z are exact.
DirectionSet directions_double_gauss(int order);
/// Fully symmetric LQ_N (Carlson 1971): order (order + 2) directions on `order` levels about each axis.
DirectionSet directions_level_symmetric(int order);
/// T_N (Thurgood, Pollard and Becker 1995): 8 order^2 directions, one in each of order^2 triangles per
/// octant.
DirectionSet directions_thurgood(int order);
/// Linear discontinuous finite elements on spherical quadrilaterals (Lau and Adams 2017): 96 order^2.
DirectionSet directions_ldfe_sq(int order);

/// Lebedev's rule of this degree (Lebedev and Laikov 1999): exact up to it, closed under the octahedral
/// group, with directions on the axes. The degrees are lebedev_degrees().
DirectionSet directions_lebedev(int degree);
/// Odd degrees of the rules with positive weights: 3 … 131.
const std::vector<int>& lebedev_degrees();

/// Flatland: `order` directions (a multiple of 4) at half steps on the circle z = 0, of equal weights that
/// sum to 2 pi. Exact for cos(k t) and sin(k t) up to k = order - 1.
DirectionSet directions_flatland(int order);

/// The set of this name. Throws InputError (without a file) with what is accepted.
DirectionSet make_directions(const std::string& name, int order);
/// The same set turned by a rotation, so that no direction keeps a special place among the axes. Throws
/// std::invalid_argument where directions leave the plane.
DirectionSet rotated(const DirectionSet& set, const Rotation& rotation);
/// A set and `count` - 1 copies of it, each turned at random; the same ones for a seed on every machine.
std::vector<DirectionSet> rotated_copies(const DirectionSet& set, int count, std::uint64_t seed);

/// Names that make_directions knows.
std::vector<std::string> direction_set_names();
/// Where the directions of the set of this name lie.
AngularSpace angular_space(const std::string& set_name);
/// Orders of the set of this name that show how it grows, at most `most`.
std::vector<int> sample_orders(const std::string& set_name, int most);
/// Empty where the order suits the set, else why not and what is accepted.
std::string check_direction_order(const std::string& name, int order);

}  // namespace etendue
