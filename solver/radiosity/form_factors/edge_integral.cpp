// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/form_factors/edge_integral.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/quadrature/adaptive_rule.h"

namespace etendue {
namespace {

// Edges whose directions have a smaller cosine than this add nothing.
constexpr double perpendicular = 1e-15;
// Squared sine between edges below which they count as parallel.
constexpr double parallel = 1e-12;
// Edges whose middles are this many times their lengths apart see each other through a smooth kernel.
constexpr double well_apart = 1.5;

/// x ln((x^2 + d^2)/unit^2)/2 - x: with d atan(x/d) the primitive of ln(r/unit) along a line at distance d.
double smooth_part(double x, double square, double inverse_unit_square) {
  const double r2 = x * x + square;
  return r2 > 0 ? x * (0.5 * std::log(r2 * inverse_unit_square) - 1) : 0;
}

/// The integral of ln(r/unit) from a point over an edge.
class LogDistance {
 public:
  LogDistance(const ContourEdge& edge, double unit)
      : from_(edge.from), along_(edge.to - edge.from), inverse_unit_square_(1 / (unit * unit)) {
    length_ = along_.norm();
    along_ /= length_;
  }

  double at(const Vec3& point) const {
    const Vec3 away = point - from_;
    const double foot = away.dot(along_);
    // Not from the lengths: their squares would cancel.
    const double square = (away - foot * along_).squaredNorm(), distance = std::sqrt(square);
    const double begin = -foot, end = length_ - foot;
    const double angle = std::atan2(distance * length_, square + begin * end);
    return smooth_part(end, square, inverse_unit_square_) - smooth_part(begin, square, inverse_unit_square_) +
           distance * angle;
  }

  const Vec3& along() const { return along_; }
  double length() const { return length_; }

 private:
  Vec3 from_, along_;
  double length_ = 0;
  double inverse_unit_square_;
};

}  // namespace

double contour_integral(const ContourEdge& first, const ContourEdge& second, double unit, double tolerance) {
  const LogDistance inner(second, unit);
  Vec3 along = first.to - first.from;
  const double length = along.norm();
  along /= length;
  const double cosine = along.dot(inner.along());
  if (std::abs(cosine) < perpendicular) return 0;
  const auto value = [&](double s) { return inner.at(first.from + s * along); };
  const Vec3 between = second.from - first.from;
  const Vec3 middles = between + (inner.length() * inner.along() - length * along) / 2;
  if (middles.norm() > well_apart * (length + inner.length()))
    return cosine * adaptive_integral(value, 0, length, tolerance);
  // Ends of the second edge, and where the lines are nearest to each other.
  const double sine2 = 1 - cosine * cosine;
  const double begin = along.dot(between);
  const double nearest = sine2 > parallel ? (begin - cosine * inner.along().dot(between)) / sine2 : 0;
  std::array<double, 5> cuts = {0, begin, begin + cosine * inner.length(), nearest, length};
  for (double& cut : cuts) cut = std::clamp(cut, 0.0, length);
  std::ranges::sort(cuts);
  double sum = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i)
    if (cuts[i] > cuts[i - 1]) sum += adaptive_integral(value, cuts[i - 1], cuts[i], tolerance / 4);
  return cosine * sum;
}

}  // namespace etendue
