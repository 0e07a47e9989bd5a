// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/albedo_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/quadrature/panel_rule.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Angles: cubics between them are right to 1e-10 where the albedo changes over a radian.
constexpr int intervals = 256;
constexpr double step = pi / 2 / intervals;

}  // namespace

AlbedoTable::AlbedoTable(const std::function<double(double)>& albedo) {
  for (int i = 0; i <= intervals; ++i) {
    const double angle = i * step;
    values_.push_back(albedo(i == intervals ? 0 : std::cos(angle)));
    if (values_.back() <= largest_) continue;
    largest_ = values_.back();
    angle_of_largest_ = angle * 180 / pi;
  }
  mean_ = integral_by_panels(0, pi / 2, intervals,
                             [this](double angle) { return std::sin(2 * angle) * at_angle(angle); });
}

double AlbedoTable::at(double cos_in) const { return at_angle(std::acos(std::clamp(cos_in, 0.0, 1.0))); }

// Lagrange's cubic through the four nearest angles.
double AlbedoTable::at_angle(double angle) const {
  const double place = angle / step;
  const int first = std::clamp(static_cast<int>(place) - 1, 0, intervals - 3);
  const double t = place - first;
  const double* y = values_.data() + first;
  return -(t - 1) * (t - 2) * (t - 3) / 6 * y[0] + t * (t - 2) * (t - 3) / 2 * y[1] -
         t * (t - 1) * (t - 3) / 2 * y[2] + t * (t - 1) * (t - 2) / 6 * y[3];
}

}  // namespace etendue
