// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/temperature_curve.h"

#include <algorithm>

namespace etendue {
namespace {

struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

ValueAndSlope read(const TemperatureCurve::Polynomial& form, double kelvin) {
  ValueAndSlope result;
  const double at = std::clamp(kelvin, form.lowest, form.highest);
  for (auto term = form.terms.rbegin(); term != form.terms.rend(); ++term)
    result = {result.value * at + *term, result.slope * at + result.value};
  if (at != kelvin) result.slope = 0;
  return result;
}

ValueAndSlope read(const TemperatureCurve::Table& form, double kelvin) {
  const auto above = std::ranges::upper_bound(form.kelvin, kelvin);
  if (above == form.kelvin.begin()) return {form.values.front(), 0};
  if (above == form.kelvin.end()) return {form.values.back(), 0};
  const auto k = static_cast<std::size_t>(above - form.kelvin.begin());
  const double slope = (form.values[k] - form.values[k - 1]) / (form.kelvin[k] - form.kelvin[k - 1]);
  return {form.values[k - 1] + slope * (kelvin - form.kelvin[k - 1]), slope};
}

bool is_constant(const TemperatureCurve::Polynomial& form) {
  return std::all_of(form.terms.begin() + 1, form.terms.end(), [](double term) { return term == 0; });
}

bool is_constant(const TemperatureCurve::Table& form) {
  return std::ranges::all_of(form.values, [&](double value) { return value == form.values.front(); });
}

}  // namespace

double TemperatureCurve::at(double kelvin) const {
  return std::visit([&](const auto& form) { return read(form, kelvin).value; }, form_);
}

double TemperatureCurve::slope_at(double kelvin) const {
  return std::visit([&](const auto& form) { return read(form, kelvin).slope; }, form_);
}

bool TemperatureCurve::is_constant() const {
  return std::visit([](const auto& form) { return etendue::is_constant(form); }, form_);
}

}  // namespace etendue
