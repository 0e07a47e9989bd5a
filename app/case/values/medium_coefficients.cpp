// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/medium_coefficients.h"

#include <fmt/format.h>

#include <cmath>

#include "app/case/values/band_values.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

// Exactly zero where the two agree.
Value difference(const Value& a, const Value& b) {
  if (!is_number(a) || !is_number(b)) return joined(a, "-", b);
  const double result = std::get<double>(a) - std::get<double>(b);
  return std::abs(result) <= written_agreement * std::abs(std::get<double>(a)) ? 0.0 : result;
}

Value band_value(const std::optional<BandValues>& values, int band) {
  return values ? value_of(*values, band) : Value(0.0);
}

// Says whether two values are the same; formulas cannot be compared.
std::string comparison(std::string_view name, const Value& given, std::string_view rule,
                       const Value& expected) {
  if (!is_number(given) || !is_number(expected))
    return fmt::format(
        "too many coefficients ({} follows from {}, and formulas cannot be compared); leave one out", name,
        rule);
  const double a = std::get<double>(given), b = std::get<double>(expected);
  if (std::abs(a - b) <= written_agreement * std::max(std::abs(a), std::abs(b))) return "";
  return fmt::format("coefficients disagree ({} = {}, but {} = {}); leave one out", name, a, rule, b);
}

}  // namespace

MatterValues matter_values(const MediumCase& medium, int band) {
  const Value absorption = band_value(medium.absorption, band),
              scattering = band_value(medium.scattering, band);
  if (!medium.extinction) return {absorption, scattering};
  const Value extinction = value_of(*medium.extinction, band);
  if (medium.albedo) {
    const Value albedo = value_of(*medium.albedo, band);
    return {product(extinction, difference(1.0, albedo)), product(extinction, albedo)};
  }
  if (medium.absorption && medium.scattering) return {absorption, scattering};
  if (medium.absorption) return {absorption, difference(extinction, absorption)};
  if (medium.scattering) return {difference(extinction, scattering), scattering};
  return {extinction, 0.0};
}

Value emission_value(const MediumCase& medium, int band) {
  if (medium.emission || !medium.power_density) return band_value(medium.emission, band);
  return product(value_of(*medium.power_density, band), 1 / full_range(medium.space));
}

std::string matter_problem(const MediumCase& medium, int band) {
  if (!medium.extinction)
    return medium.albedo ? "albedo without extinction (it does not say how far light goes); add extinction"
                         : "";
  const MatterValues values = matter_values(medium, band);
  if (medium.albedo) {
    std::string problem;
    if (medium.scattering)
      problem = comparison("scattering", value_of(*medium.scattering, band), "albedo * extinction",
                           values.scattering);
    if (problem.empty() && medium.absorption)
      problem = comparison("absorption", value_of(*medium.absorption, band), "(1 - albedo) * extinction",
                           values.absorption);
    return problem;
  }
  const Value extinction = value_of(*medium.extinction, band);
  if (medium.absorption && medium.scattering) {
    const Value sum = is_number(values.absorption) && is_number(values.scattering)
                          ? Value(std::get<double>(values.absorption) + std::get<double>(values.scattering))
                          : Value("");
    return comparison("extinction", extinction, "absorption + scattering", sum);
  }
  for (const Value& value : {values.absorption, values.scattering})
    if (is_number(value) && std::get<double>(value) < 0)
      return fmt::format(
          "coefficients disagree (extinction = {} is less than {}); extinction = absorption + scattering",
          std::get<double>(extinction), medium.absorption ? "absorption" : "scattering");
  return "";
}

std::string emission_problem(const MediumCase& medium, int band) {
  if (medium.power && (medium.emission || medium.power_density))
    return "emission is given twice (power is that of the whole region); use one of emission, power_density, "
           "power";
  if (!medium.emission || !medium.power_density) return "";
  const Value density = value_of(*medium.power_density, band);
  const char* rule = medium.space == AngularSpace::sphere ? "4 pi emission" : "2 pi emission";
  return comparison("power_density", density, rule,
                    product(value_of(*medium.emission, band), full_range(medium.space)));
}

}  // namespace etendue
