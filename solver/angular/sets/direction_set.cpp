// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/direction_set.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "solver/angular/sets/direction_order.h"

namespace etendue {
namespace {

// Two directions are the same to within rounding: directions are unit vectors.
constexpr double same_direction = 1e-12;
// Weights of mirror images and opposites, relative.
constexpr double same_weight = 1e-12;

std::vector<std::int32_t> sorted_by_x(std::span<const Vec3> directions) {
  std::vector<std::int32_t> order(directions.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [directions](std::int32_t a, std::int32_t b) {
    return directions[static_cast<std::size_t>(a)].x() < directions[static_cast<std::size_t>(b)].x();
  });
  return order;
}

/// The direction nearest to `wanted` if it is the same to within rounding, else -1.
int find_direction(std::span<const Vec3> directions, const std::vector<std::int32_t>& by_x,
                   const Vec3& wanted) {
  const auto x = [directions](std::int32_t m) { return directions[static_cast<std::size_t>(m)].x(); };
  auto at = std::lower_bound(by_x.begin(), by_x.end(), wanted.x() - same_direction,
                             [x](std::int32_t m, double value) { return x(m) < value; });
  for (; at != by_x.end() && x(*at) <= wanted.x() + same_direction; ++at)
    if ((directions[static_cast<std::size_t>(*at)] - wanted).norm() <= same_direction) return *at;
  return -1;
}

void check_directions(const std::vector<Vec3>& directions, const std::vector<double>& weights,
                      AngularSpace space) {
  if (directions.size() != weights.size() || directions.empty())
    throw std::invalid_argument("a direction set needs one weight for each direction");
  for (const Vec3& direction : directions)
    if (!(std::abs(direction.norm() - 1) <= same_direction))
      throw std::invalid_argument("a direction is not a unit vector");
  if (space == AngularSpace::plane)
    for (const Vec3& direction : directions)
      if (direction.z() != 0) throw std::invalid_argument("a direction leaves the plane");
  for (const double weight : weights)
    if (!(weight > 0)) throw std::invalid_argument("a weight is not positive");
}

/// The factor that makes the weights sum to 4 pi, or 2 pi in the plane.
double weight_scale(const std::vector<double>& weights, AngularSpace space) {
  const long double sum = std::accumulate(weights.begin(), weights.end(), 0.0L);
  const int multiple = space == AngularSpace::sphere ? 4 : 2;
  const double scale = static_cast<double>(multiple * std::numbers::pi_v<long double> / sum);
  if (!(std::abs(scale - 1) <= 1e-12)) throw std::invalid_argument("weights do not sum to the full range");
  return scale;
}

}  // namespace

DirectionSet::DirectionSet(std::string name, int order, const std::vector<Vec3>& directions,
                           const std::vector<double>& weights, AngularSpace space)
    : name_(std::move(name)), order_(order), space_(space) {
  check_directions(directions, weights, space);
  const double scale = weight_scale(weights, space);
  const std::vector<std::int32_t> by_x = sorted_by_x(directions);
  for (const std::int32_t m : upper_directions_along_curve(directions)) {
    const std::size_t at = static_cast<std::size_t>(m);
    const int opposite = find_direction(directions, by_x, -directions[at]);
    if (opposite < 0 ||
        std::abs(weights[static_cast<std::size_t>(opposite)] - weights[at]) > same_weight * weights[at])
      throw std::invalid_argument("a direction has no opposite of the same weight");
    directions_.push_back(directions[at]);
    directions_.push_back(-directions[at]);
    weights_.insert(weights_.end(), 2, weights[at] * scale);
  }
  if (directions_.size() != directions.size())
    throw std::invalid_argument("a direction has no opposite, or stands twice in the set");
  by_x_ = sorted_by_x(directions_);
}

int DirectionSet::mirrored(OrdinateIndex m, const Vec3& normal) const {
  const Vec3& before = direction(m);
  const int after = find_direction(directions_, by_x_, before - 2 * before.dot(normal) * normal);
  if (after < 0) return -1;
  const double partner = weights_[static_cast<std::size_t>(after)];
  return std::abs(partner - weight(m)) <= same_weight * partner ? after : -1;
}

double DirectionSet::half_range(const Vec3& normal) const {
  double sum = 0;
  for (std::size_t m = 0; m < directions_.size(); ++m)
    sum += weights_[m] * std::max(-directions_[m].dot(normal), 0.0);
  return sum;
}

}  // namespace etendue
