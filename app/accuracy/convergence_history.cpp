// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/accuracy/convergence_history.h"

#include <algorithm>
#include <cmath>

#include "app/compare/error_estimate.h"

namespace etendue {
namespace {

constexpr double factor_of_one = 3, factor_of_more = 1.25;
/// What an earlier change leaves to expect counts with this weight.
constexpr double weight_of_earlier = 0.5;
/// Between sizes whose change tells an error.
constexpr double least_ratio = 1.25;
/// Slower convergence than this is hardly different from none.
constexpr double lowest_order = 0.5;

/// Richardson's estimate at the fine size of a change, taken to another size.
double error_at(double size, const RefinementChange& change, std::size_t number, double order) {
  return error_of_change(change.changes[number], change.coarse / change.fine, order) *
         std::pow(size / change.fine, order);
}

}  // namespace

double observed_order(const RefinementChange& first, const RefinementChange& second, std::size_t number,
                      double lowest, double highest) {
  const double before = std::abs(first.changes[number]), after = std::abs(second.changes[number]);
  // Positive where the order is above p, as both sides grow with it.
  const auto excess = [&](double p) {
    return before * (std::pow(second.coarse, p) - std::pow(second.fine, p)) -
           after * (std::pow(first.coarse, p) - std::pow(first.fine, p));
  };
  if (excess(highest) >= 0) return highest;
  if (excess(lowest) <= 0) return lowest;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = (lowest + highest) / 2;
    (excess(middle) > 0 ? lowest : highest) = middle;
  }
  return lowest;
}

void ConvergenceHistory::add(RefinementChange change) {
  if (pending_) {
    change.coarse = pending_->coarse;
    for (std::size_t i = 0; i < change.changes.size(); ++i) change.changes[i] += pending_->changes[i];
    pending_.reset();
  }
  if (change.coarse < least_ratio * change.fine)
    pending_ = std::move(change);
  else
    changes_.push_back(std::move(change));
}

std::vector<double> ConvergenceHistory::errors(double size, double highest_order) const {
  const RefinementChange& last = changes_.back();
  std::vector<double> result(last.changes.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (changes_.size() == 1) {
      result[i] = factor_of_one * error_at(size, last, i, highest_order);
      continue;
    }
    const RefinementChange& before = changes_[changes_.size() - 2];
    const double order =
        observed_order(before, last, i, std::min(lowest_order, highest_order), highest_order);
    result[i] = factor_of_more * std::max(error_at(size, last, i, order),
                                          weight_of_earlier * error_at(size, before, i, order));
  }
  return result;
}

}  // namespace etendue
