// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;

// Moments up to this degree are computed once: what a solution and its reports ask for.
constexpr int kept_degrees = 16;
// The first and last cosine may miss -1 and 1 by the digits of a table.
constexpr double end_rounding = 1e-6;

struct Node {
  double x;  ///< in [-1, 1]
  double weight;
};

/// Gauss and Legendre's rule of five points: exact to degree 9, so to P_8 times a straight line.
std::array<Node, 5> five_points() {
  const double root = 2 * std::sqrt(10.0 / 7);
  const double inner = std::sqrt(5 - root) / 3, outer = std::sqrt(5 + root) / 3;
  const double inner_weight = (322 + 13 * std::sqrt(70.0)) / 900;
  const double outer_weight = (322 - 13 * std::sqrt(70.0)) / 900;
  return {{{-outer, outer_weight},
           {-inner, inner_weight},
           {0, 128.0 / 225},
           {inner, inner_weight},
           {outer, outer_weight}}};
}

/// How many pieces of a segment the rule needs: one where it is exact, else a radian of P_l's swing each.
int pieces(double low, double high, int degree) {
  if (degree <= 8) return 1;
  return std::max(1, static_cast<int>(std::ceil(degree * (std::acos(low) - std::acos(high)))));
}

double trapezoid(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 1; i < x.size(); ++i) sum += (x[i] - x[i - 1]) * (y[i] + y[i - 1]) / 2;
  return sum;
}

bool is_monotone(const std::vector<double>& x) {
  return std::ranges::is_sorted(x, std::less_equal<>{}) || std::ranges::is_sorted(x, std::greater_equal<>{});
}

}  // namespace

PhaseTable::PhaseTable(std::vector<double> cosines, std::vector<double> values)
    : cosines_(std::move(cosines)), values_(std::move(values)) {
  if (cosines_.front() > cosines_.back()) {
    std::ranges::reverse(cosines_);
    std::ranges::reverse(values_);
  }
  cosines_.front() = -1;
  cosines_.back() = 1;
  integral_ = 2 * pi * trapezoid(cosines_, values_);
  for (double& value : values_) value /= integral_;
  moments_.push_back(1);
  for (int l = 1; l <= kept_degrees; ++l) moments_.push_back(moment_by_quadrature(l));
}

double PhaseTable::value(double mu) const {
  const auto above = std::upper_bound(cosines_.begin() + 1, cosines_.end() - 1, mu);
  const std::size_t i = static_cast<std::size_t>(above - cosines_.begin());
  const double part = std::clamp((mu - cosines_[i - 1]) / (cosines_[i] - cosines_[i - 1]), 0.0, 1.0);
  return (1 - part) * values_[i - 1] + part * values_[i];
}

double PhaseTable::moment(int degree) const {
  const std::size_t l = static_cast<std::size_t>(degree);
  return l < moments_.size() ? moments_[l] : moment_by_quadrature(degree);
}

double PhaseTable::moment_by_quadrature(int degree) const {
  static const std::array<Node, 5> rule = five_points();
  double sum = 0;
  for (std::size_t i = 1; i < cosines_.size(); ++i) {
    const double low = cosines_[i - 1], width = cosines_[i] - low;
    const int count = pieces(low, cosines_[i], degree);
    for (int piece = 0; piece < count; ++piece)
      for (const Node& node : rule) {
        const double part = (piece + (1 + node.x) / 2) / count;
        const double linear = (1 - part) * values_[i - 1] + part * values_[i];
        sum += node.weight * width / (2 * count) * linear *
               std::legendre(static_cast<unsigned>(degree), low + part * width);
      }
  }
  return 2 * pi * sum;
}

double value_of(const PhaseTable& phase, double mu) { return phase.value(mu); }

double moment_of(const PhaseTable& phase, int degree) { return phase.moment(degree); }

std::string name_of(const PhaseTable& phase) {
  return fmt::format("table of {} cosines, divided by its integral {:.6g}, g = {:.4g}", phase.size(),
                     phase.integral(), phase.moment(1));
}

std::string table_problem(const std::vector<double>& cosines, const std::vector<double>& values) {
  if (cosines.size() < 2) return "has fewer than two rows; use mu and p from mu = -1 to 1";
  if (!is_monotone(cosines)) return "mu must rise or fall throughout; use each cosine once, in order";
  const auto [low, high] = std::minmax(cosines.front(), cosines.back());
  if (std::abs(low + 1) > end_rounding || std::abs(high - 1) > end_rounding)
    return fmt::format("mu runs from {:g} to {:g} (p is needed at every angle); use cosines from -1 to 1",
                       low, high);
  const auto negative = std::ranges::find_if(values, [](double value) { return !(value >= 0); });
  if (negative != values.end())
    return fmt::format("p = {:g} at mu = {:g} is negative; use values of at least 0", *negative,
                       cosines[static_cast<std::size_t>(negative - values.begin())]);
  if (trapezoid(cosines, values) == 0) return "p is zero throughout; use a function with some scattering";
  return {};
}

}  // namespace etendue
