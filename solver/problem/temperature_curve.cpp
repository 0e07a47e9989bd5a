// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/temperature_curve.h"

#include <algorithm>

namespace etendue {
namespace {

ValueAndSlope read(const TemperatureCurve::Polynomial& form, double kelvin) {
  ValueAndSlope result;
  const double at = std::clamp(kelvin, form.lowest, form.highest);
  for (auto term = form.terms.rbegin(); term != form.terms.rend(); ++term)
    result = {result.value * at + *term, result.slope * at + result.value};
  if (at != kelvin) result.slope = 0;
  return result;
}

ValueAndSlope read(const TemperatureCurve::Table& form, double kelvin) {
  return piecewise_linear(form.kelvin, form.values, kelvin);
}

bool is_constant(const TemperatureCurve::Polynomial& form) {
  return std::all_of(form.terms.begin() + 1, form.terms.end(), [](double term) { return term == 0; });
}

bool is_constant(const TemperatureCurve::Table& form) {
  return std::ranges::all_of(form.values, [&](double value) { return value == form.values.front(); });
}

}  // namespace

ValueAndSlope TemperatureCurve::with_slope_at(double kelvin) const {
  return std::visit([&](const auto& form) { return read(form, kelvin); }, form_);
}

bool TemperatureCurve::is_constant() const {
  return std::visit([](const auto& form) { return etendue::is_constant(form); }, form_);
}

}  // namespace etendue
