// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace etendue {

/// Speeds up an iteration x + f(x) by the steps before (Anderson 1965; Walker and Ni 2011, algorithm AA).
class AndersonMixing {
 public:
  /// Norms are weighted, a weight for each number of x. At most `depth` steps are remembered.
  AndersonMixing(std::vector<double> weights, std::size_t depth);

  /// What is to be added to x, given the step f(x).
  std::vector<double> step(std::span<const double> x, std::span<const double> f);

 private:
  using Vector = std::vector<double>;

  double dot(std::span<const double> a, std::span<const double> b) const;
  void remember(std::span<const double> x, std::span<const double> f);

  Vector weights_;
  std::size_t depth_;
  Vector last_x_, last_f_;                 ///< empty at first
  std::vector<Vector> steps_x_, steps_f_;  ///< differences of x and of f, the oldest first
};

}  // namespace etendue
