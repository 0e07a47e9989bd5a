// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/conserve_moments.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace etendue {
namespace {

using Vec4 = Eigen::Vector4d;

constexpr int most_multiplier_steps = 60, most_step_halvings = 40;
/// Error of the four moments at which the iteration ends, and up to which its result is taken.
constexpr double exact = 1e-14, good_enough = 1e-9;
/// Part of the decrease by the gradient that a step has to bring (Armijo 1966).
constexpr double sufficient_decrease = 1e-4;

/// The convex function, its gradient and its second derivatives at the multipliers (a, b).
struct Potential {
  double value = 0;
  Vec4 gradient = Vec4::Zero();
  Eigen::Matrix4d curvature = Eigen::Matrix4d::Zero();
};

class MomentFit {
 public:
  MomentFit(const DirectionSet& directions, const Vec3& mean, std::span<const double> p)
      : directions_(directions), p_(p), largest_(*std::ranges::max_element(p)) {
    target_ << 1, mean;
  }

  Potential at(const Vec4& multipliers) const {
    Potential found;
    for (std::size_t m = 0; m < p_.size(); ++m) {
      const Vec4 v = moments_of(m);
      const double value = directions_.weights()[m] * largest_ * std::exp(share(m) * multipliers.dot(v));
      found.value += value;
      found.gradient += value * share(m) * v;
      found.curvature += value * share(m) * share(m) * v * v.transpose();
    }
    found.value -= multipliers.dot(target_);
    found.gradient -= target_;
    return found;
  }

  /// Multipliers of the minimum, or of where no step leads further down.
  Vec4 minimum() const {
    Vec4 multipliers = Vec4::Zero();
    Potential here = at(multipliers);
    for (int step = 0; step < most_multiplier_steps && here.gradient.lpNorm<Eigen::Infinity>() > exact;
         ++step) {
      const Vec4 change = -here.curvature.ldlt().solve(here.gradient);
      if (!change.allFinite() || !descend(change, multipliers, here)) break;
    }
    return multipliers;
  }

  double corrected(std::size_t m, const Vec4& multipliers) const {
    return p_[m] * std::exp(share(m) * multipliers.dot(moments_of(m)));
  }

 private:
  double share(std::size_t m) const { return p_[m] / largest_; }
  Vec4 moments_of(std::size_t m) const {
    Vec4 v;
    v << 1, directions_.directions()[m];
    return v;
  }
  /// Takes the step, or a part of it that leads down; false where none does.
  bool descend(const Vec4& change, Vec4& multipliers, Potential& here) const {
    const double slope = here.gradient.dot(change);
    double part = 1;
    for (int halving = 0; halving < most_step_halvings; ++halving, part /= 2) {
      const Potential there = at(multipliers + part * change);
      // Close to the minimum the value is constant to rounding: there the gradient tells.
      const bool down = there.value <= here.value + sufficient_decrease * part * slope ||
                        there.gradient.norm() < 0.5 * here.gradient.norm();
      if (!std::isfinite(there.value) || !down) continue;
      multipliers += part * change;
      here = there;
      return true;
    }
    return false;
  }

  const DirectionSet& directions_;
  std::span<const double> p_;
  double largest_;
  Vec4 target_;
};

}  // namespace

void conserve_moments(const DirectionSet& directions, const Vec3& mean, std::span<double> p) {
  const MomentFit fit(directions, mean, p);
  const Vec4 multipliers = fit.minimum();
  std::vector<double> corrected(p.begin(), p.end());
  if (fit.at(multipliers).gradient.lpNorm<Eigen::Infinity>() < good_enough)
    for (std::size_t m = 0; m < p.size(); ++m) corrected[m] = fit.corrected(m, multipliers);
  double integral = 0;
  for (std::size_t m = 0; m < p.size(); ++m) integral += directions.weights()[m] * corrected[m];
  for (std::size_t m = 0; m < p.size(); ++m) p[m] = corrected[m] / integral;
}

}  // namespace etendue
