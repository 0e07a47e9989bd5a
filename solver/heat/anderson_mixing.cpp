// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/anderson_mixing.h"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

namespace etendue {
namespace {

/// Of the normal equations, relative to their diagonal: steps that all but agree are rounding.
constexpr double regularization = 1e-12;

std::vector<double> difference(std::span<const double> a, std::span<const double> b) {
  std::vector<double> result(a.begin(), a.end());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= b[i];
  return result;
}

}  // namespace

AndersonMixing::AndersonMixing(std::vector<double> weights, std::size_t depth)
    : weights_(std::move(weights)), depth_(depth) {}

double AndersonMixing::dot(std::span<const double> a, std::span<const double> b) const {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += weights_[i] * a[i] * b[i];
  return sum;
}

void AndersonMixing::remember(std::span<const double> x, std::span<const double> f) {
  if (!last_x_.empty()) {
    steps_x_.push_back(difference(x, last_x_));
    steps_f_.push_back(difference(f, last_f_));
  }
  if (steps_x_.size() > depth_) {
    steps_x_.erase(steps_x_.begin());
    steps_f_.erase(steps_f_.begin());
  }
  last_x_.assign(x.begin(), x.end());
  last_f_.assign(f.begin(), f.end());
}

std::vector<double> AndersonMixing::step(std::span<const double> x, std::span<const double> f) {
  remember(x, f);
  std::vector<double> result(f.begin(), f.end());
  const auto count = static_cast<Eigen::Index>(steps_f_.size());
  if (count == 0) return result;
  Eigen::MatrixXd normal(count, count);
  Eigen::VectorXd right(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector& step = steps_f_[static_cast<std::size_t>(i)];
    right[i] = dot(step, f);
    for (Eigen::Index k = 0; k < count; ++k) normal(i, k) = dot(step, steps_f_[static_cast<std::size_t>(k)]);
    normal(i, i) *= 1 + regularization;
  }
  const Eigen::VectorXd factors = normal.ldlt().solve(right);
  if (!factors.allFinite()) return result;
  for (std::size_t k = 0; k < steps_f_.size(); ++k)
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] -= factors[static_cast<Eigen::Index>(k)] * (steps_x_[k][i] + steps_f_[k][i]);
  return result;
}

}  // namespace etendue
