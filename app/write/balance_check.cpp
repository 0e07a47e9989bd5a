// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/balance_check.h"

#include <fmt/format.h>

#include <cmath>

namespace etendue {
namespace {

/// Standard errors of the residual that photons may be off by.
constexpr double standard_errors = 3;

double allowed_residual(const RunResult& result, std::size_t band) {
  const double statistical = result.errors ? standard_errors * result.errors->balances[band].residual : 0;
  return result.input.balance_tolerance + (std::isfinite(statistical) ? statistical : 0);
}

}  // namespace

// Written so that a residual that is not a number is not balanced.
bool is_balanced(const RunResult& result, std::size_t band) {
  return std::abs(result.balances[band].residual) <= allowed_residual(result, band);
}

bool is_balanced(const RunResult& result) {
  for (std::size_t band = 0; band < result.balances.size(); ++band)
    if (!is_balanced(result, band)) return false;
  return true;
}

std::string balance_warning(const RunResult& result) {
  std::string bands;
  for (std::size_t band = 0; band < result.balances.size(); ++band)
    if (!is_balanced(result, band))
      bands += fmt::format("{}{:.2g} % in band {}", bands.empty() ? "" : ", ",
                           100 * result.balances[band].residual, result.problem.bands().names[band]);
  if (bands.empty()) return "";
  return fmt::format(
      "WARNING: NOT BALANCED: {} of the power is lost (negative: gained), more than solve.balance_tolerance "
      "= "
      "{}; do not trust these results\n",
      bands, result.input.balance_tolerance);
}

}  // namespace etendue
