// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/curve_value.h"

#include <fmt/format.h>

#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

std::string text_of(const TemperatureCurve::Polynomial& form, const std::string& kelvin) {
  std::string text =
      fmt::format("polynomial(min(max({},{:.17g}),{:.17g})", kelvin, form.lowest, form.highest);
  for (const double term : form.terms) text += fmt::format(",{:.17g}", term);
  return text + ")";
}

/// The first value, and for each interval its slope times how far the temperature is in it.
std::string text_of(const TemperatureCurve::Table& form, const std::string& kelvin) {
  std::string text = fmt::format("({:.17g}", form.values.front());
  for (std::size_t k = 1; k < form.kelvin.size(); ++k) {
    const double slope = (form.values[k] - form.values[k - 1]) / (form.kelvin[k] - form.kelvin[k - 1]);
    if (slope != 0)
      text += fmt::format("+({:.17g})*(min(max({},{:.17g}),{:.17g})-{:.17g})", slope, kelvin,
                          form.kelvin[k - 1], form.kelvin[k], form.kelvin[k - 1]);
  }
  return text + ")";
}

}  // namespace

std::string curve_text(const TemperatureCurve& curve, const std::string& kelvin) {
  return std::visit([&](const auto& form) { return text_of(form, kelvin); }, curve.form());
}

Value curve_value(const TemperatureCurve& curve, const Value& kelvin) {
  if (curve.is_constant()) return curve.at(0);
  if (is_number(kelvin)) return curve.at(std::get<double>(kelvin));
  Formula formula = term(kelvin);
  formula.text = curve_text(curve, formula.text);
  return formula;
}

}  // namespace etendue
