// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/balance_check.h"

#include <fmt/format.h>

#include <cmath>

namespace etendue {
namespace {

/// Standard errors of the residual that photons may be off by.
constexpr double standard_errors = 3;

/// Of solve.balance_tolerance, from which on a residual is worth a word.
constexpr double noticeable_part = 0.3;

/// The residual that a part of the tolerance allows.
double allowed_residual(const RunResult& result, std::size_t band, double part = 1) {
  const double statistical = result.errors ? standard_errors * result.errors->balances[band].residual : 0;
  return part * result.input.balance_tolerance + (std::isfinite(statistical) ? statistical : 0);
}

std::string residual_text(const RunResult& result, std::size_t band) {
  return fmt::format("{:.2g} % in band {}", 100 * result.balances[band].residual,
                     result.problem.bands().names[band]);
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
    if (!is_balanced(result, band)) bands += (bands.empty() ? "" : ", ") + residual_text(result, band);
  if (bands.empty()) return "";
  return fmt::format(
      "WARNING: NOT BALANCED: {} of the power is lost (negative: gained), more than solve.balance_tolerance "
      "= "
      "{}; do not trust these results\n",
      bands, result.input.balance_tolerance);
}

std::string balance_caution(const RunResult& result) {
  std::string bands;
  for (std::size_t band = 0; band < result.balances.size(); ++band)
    if (is_balanced(result, band) &&
        std::abs(result.balances[band].residual) > allowed_residual(result, band, noticeable_part))
      bands += (bands.empty() ? "" : ", ") + residual_text(result, band);
  if (bands.empty()) return "";
  return fmt::format(
      "warning: {} of the power is lost (negative: gained), more than {:.2g} % (three tenths of "
      "solve.balance_tolerance); expect powers to be off by as much; smaller cells help\n",
      bands, 100 * noticeable_part * result.input.balance_tolerance);
}

}  // namespace etendue
