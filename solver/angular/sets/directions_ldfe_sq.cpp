// SPDX-License-Identifier: AGPL-3.0-or-later
// Linear discontinuous finite elements on spherical quadrilaterals: C. Y. Lau and M. L. Adams, Discrete
// ordinates quadratures based on linear and quadratic discontinuous finite elements over spherical
// quadrilaterals, Nucl. Sci. Eng. 185 (2017) 36-52. The positions are found by Newton's method, so that
// every weight equals the solid angle of its own quarter of a quadrilateral.
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/quadrature/gauss_legendre.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/angular/sets/octant.h"
#include "solver/angular/sets/refinement.h"

namespace etendue {
namespace {

using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

const double half_side = 1 / std::sqrt(3.0);  // of the cube inscribed in the unit sphere

/// A rectangle on the face w = half_side of the cube.
struct Rectangle {
  double u0, u1, v0, v1;
};

Vec3 on_sphere(double u, double v) {
  return Vec3(u, v, half_side) / std::sqrt(u * u + v * v + half_side * half_side);
}

/// Four functions that span 1, x, y and z on the sphere, but stay far from dependent on a small part of it:
/// with d the displacement from a centre on the sphere and h the size of the part, 1, d.e1/h, d.e2/h and
/// d.d/h^2 (which is 2 - 2 times the component along the centre).
class LinearBasis {
 public:
  LinearBasis(const Vec3& center, double size)
      : center_(center), size_(size), e1_(center.unitOrthogonal()), e2_(center.cross(e1_)) {}
  Vec4 operator()(const Vec3& direction) const {
    const Vec3 d = (direction - center_) / size_;
    return {1, d.dot(e1_), d.dot(e2_), d.squaredNorm()};
  }

 private:
  Vec3 center_;
  double size_;
  Vec3 e1_, e2_;
};

/// Integrals of the basis over the rectangle seen from the centre: dw = half_side / r^3 du dv.
Vec4 integrate(const LinearBasis& basis, const Rectangle& r) {
  static const GaussRule gauss = gauss_legendre(16);
  const double du = (r.u1 - r.u0) / 2, dv = (r.v1 - r.v0) / 2;
  Vec4 sum = Vec4::Zero();
  for (std::size_t i = 0; i < gauss.nodes.size(); ++i)
    for (std::size_t j = 0; j < gauss.nodes.size(); ++j) {
      const double u = r.u0 + du * (1 + gauss.nodes[i]), v = r.v0 + dv * (1 + gauss.nodes[j]);
      const double radius = std::sqrt(u * u + v * v + half_side * half_side);
      const double weight =
          gauss.weights[i] * gauss.weights[j] * du * dv * half_side / (radius * radius * radius);
      sum += weight * basis(on_sphere(u, v));
    }
  return sum;
}

/// The smallest change with slope * change = excess. The slope has rank 3: the sum of the weights is the
/// solid angle of the quadrilateral wherever the points are.
Vec4 smallest_step(const Mat4& slope, const Vec4& excess) {
  Eigen::JacobiSVD<Mat4> svd(slope, Eigen::ComputeFullU | Eigen::ComputeFullV);
  svd.setThreshold(1e-6);  // above the error of the differences, far below the smallest true value
  return svd.solve(excess);
}

/// The quarters of a quadrilateral and the points in them. Corners are in the order (u0, v0), (u1, v0),
/// (u0, v1), (u1, v1).
class Quadrilateral {
 public:
  explicit Quadrilateral(const Rectangle& r)
      : center_u_((r.u0 + r.u1) / 2),
        center_v_((r.v0 + r.v1) / 2),
        basis_(on_sphere(center_u_, center_v_), std::hypot(r.u1 - r.u0, r.v1 - r.v0)),
        integrals_(integrate(basis_, r)) {
    corners_ = {{{r.u0, r.v0}, {r.u1, r.v0}, {r.u0, r.v1}, {r.u1, r.v1}}};
    const std::array<Rectangle, 4> quarters = {{{r.u0, center_u_, r.v0, center_v_},
                                                {center_u_, r.u1, r.v0, center_v_},
                                                {r.u0, center_u_, center_v_, r.v1},
                                                {center_u_, r.u1, center_v_, r.v1}}};
    for (int k = 0; k < 4; ++k)
      solid_angles_[k] = integrate(basis_, quarters[static_cast<std::size_t>(k)])[0];
  }

  Vec3 direction(const Vec4& position, int k) const {
    const auto& corner = corners_[static_cast<std::size_t>(k)];
    return on_sphere(center_u_ + position[k] * (corner[0] - center_u_),
                     center_v_ + position[k] * (corner[1] - center_v_));
  }

  /// Weights with which points at these fractions of the way from the centre to the corners integrate 1, x,
  /// y and z exactly.
  Vec4 weights(const Vec4& position) const {
    Mat4 values;
    for (int k = 0; k < 4; ++k) values.col(k) = basis_(direction(position, k));
    return values.partialPivLu().solve(integrals_);
  }

  /// The positions whose weights are the solid angles of the quarters.
  Vec4 balanced_position() const {
    constexpr int most_steps = 20;       // 4 to 6 are needed
    constexpr double tolerance = 1e-12;  // relative; rounding leaves about 1e-14
    Vec4 position = Vec4::Constant(half_side);
    for (int step = 0; step < most_steps; ++step) {
      const Vec4 excess = relative_excess(position);
      position -= smallest_step(excess_slope(position), excess);
      if (excess.cwiseAbs().maxCoeff() < tolerance) return position;
    }
    throw std::logic_error("ldfe-sq: positions in a quadrilateral do not converge");
  }

 private:
  /// (weight - solid angle) / solid angle of each quarter.
  Vec4 relative_excess(const Vec4& position) const {
    return (weights(position) - solid_angles_).cwiseQuotient(solid_angles_);
  }

  /// Central differences: Newton's method stays fast, and the limit does not depend on their error.
  Mat4 excess_slope(const Vec4& position) const {
    constexpr double step = 1e-5;
    Mat4 slope;
    for (int k = 0; k < 4; ++k) {
      const Vec4 change = step * Vec4::Unit(k);
      slope.col(k) = (relative_excess(position + change) - relative_excess(position - change)) / (2 * step);
    }
    return slope;
  }

  double center_u_, center_v_;
  LinearBasis basis_;
  Vec4 integrals_;
  Vec4 solid_angles_;
  std::array<std::array<double, 2>, 4> corners_;
};

/// Lines that divide a quarter of the cube's face into quadrilaterals of similar solid angle (Lau and
/// Adams): equal steps of angle along the diagonal, stretched a little.
std::vector<double> lines(int order) {
  constexpr double stretch = 0.10005, phase = 1.0185;
  const double step = std::acos(half_side) / order, quarter = phase * std::numbers::pi / 2;
  std::vector<double> at{0.0};
  for (int i = 1; i < order; ++i) {
    const double angle = i * step * (1 + stretch * (std::cos(quarter * i / order) - std::cos(quarter)));
    at.push_back(half_side * std::tan(angle) / std::numbers::sqrt2);
  }
  at.push_back(half_side);
  return at;
}

/// A quarter of the face, u and v > 0. Points below the diagonal are computed, those above are their images,
/// so that u and v swap exactly.
WeightedDirections quarter_face(int order) {
  WeightedDirections face;
  const auto append = [&face](const Vec3& direction, double weight) {
    face.directions.push_back(direction);
    face.weights.push_back(weight);
  };
  const auto append_pair = [&append](const Vec3& d, double weight) {
    append(d, weight);
    append(Vec3(d.y(), d.x(), d.z()), weight);
  };
  const std::vector<double> at = lines(order);
  for (std::size_t i = 0; i + 1 < at.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const Quadrilateral quadrilateral({at[i], at[i + 1], at[j], at[j + 1]});
      const Vec4 position = quadrilateral.balanced_position(), weight = quadrilateral.weights(position);
      const auto direction = [&](int k) { return quadrilateral.direction(position, k); };
      if (i == j) {  // corners 0 and 3 lie on the diagonal, corner 2 is the image of corner 1
        append(direction(0), weight[0]);
        append_pair(direction(1), weight[1]);
        append(direction(3), weight[3]);
      } else {
        for (int k = 0; k < 4; ++k) append_pair(direction(k), weight[k]);
      }
    }
  return face;
}

/// Splits the quadrilaterals of one quarter of a face, seen from the octant x, y, z > 0.
class RefinedQuarter {
 public:
  /// `axis` is that of the cone in the frame of the quarter face, a unit vector.
  RefinedQuarter(const Vec3& axis, double radians, int levels, WeightedDirections& points)
      : axis_(axis), radians_(radians), levels_(levels), points_(points) {}

  void append(const Rectangle& r, int level = 0) {
    if (level < levels_ && meets_cone(r)) {
      const double u = (r.u0 + r.u1) / 2, v = (r.v0 + r.v1) / 2;
      for (const Rectangle& quarter : {Rectangle{r.u0, u, r.v0, v}, Rectangle{u, r.u1, r.v0, v},
                                       Rectangle{r.u0, u, v, r.v1}, Rectangle{u, r.u1, v, r.v1}})
        append(quarter, level + 1);
      return;
    }
    const Quadrilateral quadrilateral(r);
    const Vec4 position = quadrilateral.balanced_position(), weight = quadrilateral.weights(position);
    for (int k = 0; k < 4; ++k) {
      points_.directions.push_back(quadrilateral.direction(position, k));
      points_.weights.push_back(weight[k]);
    }
    if (points_.weights.size() > most_directions)
      throw std::length_error("more than 100000 directions: each costs a sweep in every iteration");
  }

 private:
  static constexpr std::size_t most_directions = 100000;

  /// Angle [rad] within which circle and cone touch, so that rounding does not tell opposites apart.
  static constexpr double touching = 1e-9;

  /// Returns whether the circle around the quadrilateral meets the cone or its opposite.
  bool meets_cone(const Rectangle& r) const {
    const Vec3 center = on_sphere((r.u0 + r.u1) / 2, (r.v0 + r.v1) / 2);
    const auto angle = [](const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); };
    double radius = 0;
    for (const double u : {r.u0, r.u1})
      for (const double v : {r.v0, r.v1}) radius = std::max(radius, angle(center, on_sphere(u, v)));
    const double distance = angle(center, axis_);
    return std::min(distance, std::numbers::pi - distance) < radians_ + radius + touching;
  }

  Vec3 axis_;
  double radians_;
  int levels_;
  WeightedDirections& points_;
};

constexpr int constraints = 21;
using Constraints = Eigen::Matrix<double, constraints, 1>;

/// 1, |x|, |y| and |z| in each pair of opposite octants, and the products of two coordinates (but z^2, which
/// follows from the others and 1).
Constraints constrained_functions(const Vec3& d) {
  Constraints values = Constraints::Zero();
  const bool flip = d.z() < 0;
  const int octant = ((d.x() < 0) != flip ? 1 : 0) + ((d.y() < 0) != flip ? 2 : 0);
  values.segment<4>(4 * octant) << 1, std::abs(d.x()), std::abs(d.y()), std::abs(d.z());
  values.tail<5>() << d.x() * d.x(), d.y() * d.y(), d.x() * d.y(), d.y() * d.z(), d.z() * d.x();
  return values;
}

/// Symmetry gives the unrefined set its second moments. Here weights are multiplied by 1 + f, f as small as
/// it can be in the mean square, so that they are exact again and the moments of each octant stay as they
/// are.
void restore_second_moments(WeightedDirections& set) {
  Eigen::Matrix<double, constraints, constraints> products;
  products.setZero();
  Constraints excess = Constraints::Zero();
  for (std::size_t m = 0; m < set.weights.size(); ++m) {
    const Constraints values = constrained_functions(set.directions[m]);
    products += set.weights[m] * values * values.transpose();
    excess.tail<5>() += set.weights[m] * values.tail<5>();
  }
  const double exact = 4 * std::numbers::pi / 3;
  excess[constraints - 5] -= exact;
  excess[constraints - 4] -= exact;
  const Constraints factors = products.ldlt().solve(-excess);
  for (std::size_t m = 0; m < set.weights.size(); ++m)
    set.weights[m] *= 1 + factors.dot(constrained_functions(set.directions[m]));
}

}  // namespace

DirectionSet directions_ldfe_sq(int order, const ConeRefinement& refinement) {
  // The four weights of a small quadrilateral hang on its curvature: beyond this rounding decides them.
  constexpr int finest = 32;
  if (std::ldexp(order, refinement.levels) > finest)
    throw std::length_error("splits quadrilaterals beyond those of order 32, which rounding spoils");
  const Vec3 axis = refinement.direction.normalized();
  const std::vector<double> at = lines(order);
  WeightedDirections all;
  for (int signs = 0; signs < 8; ++signs)
    for (int face = 0; face < 3; ++face) {
      const Vec3 sign(signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1);
      // The point (u, v, w) of the quarter face is (x, y, z)[i] = sign[i] (u, v, w)[(face + i) % 3].
      Vec3 in_quarter;
      for (int i = 0; i < 3; ++i) in_quarter[(face + i) % 3] = sign[i] * axis[i];
      WeightedDirections points;
      RefinedQuarter quarter(in_quarter, refinement.angle * std::numbers::pi / 180, refinement.levels,
                             points);
      for (std::size_t i = 0; i + 1 < at.size(); ++i)
        for (std::size_t j = 0; j + 1 < at.size(); ++j) quarter.append({at[i], at[i + 1], at[j], at[j + 1]});
      for (const Vec3& d : points.directions)
        all.directions.emplace_back(sign[0] * d[face], sign[1] * d[(face + 1) % 3],
                                    sign[2] * d[(face + 2) % 3]);
      all.weights.insert(all.weights.end(), points.weights.begin(), points.weights.end());
    }
  restore_second_moments(all);
  return DirectionSet("refined ldfe-sq", order, all.directions, all.weights);
}

DirectionSet directions_ldfe_sq(int order) {
  const WeightedDirections face = quarter_face(order);
  WeightedDirections octant;
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < face.directions.size(); ++i) {
      const Vec3& d = face.directions[i];
      octant.directions.emplace_back(d[axis], d[(axis + 1) % 3], d[(axis + 2) % 3]);
      octant.weights.push_back(face.weights[i]);
    }
  const WeightedDirections all = mirror_octant(octant);
  return DirectionSet("ldfe-sq", order, all.directions, all.weights);
}

}  // namespace etendue
