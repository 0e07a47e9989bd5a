// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "app/run/report/report_parts.h"

namespace etendue {
namespace {

std::string modulated_text(const TimeResult& time, const std::string& unit) {
  if (time.modulated.empty()) return "";
  if (time.quantities.size() * (time.modulated.size() - 1) > longest_report_table)
    return fmt::format("\nmodulated light: {} numbers at {} frequencies, see frequency.csv\n",
                       time.quantities.size(), time.modulated.size() - 1);
  TextTable table({"of", "quantity", "band", fmt::format("frequency [1/{}]", unit), "amplitude", "unit",
                   "phase [degree]", "modulation"},
                  {Align::left, Align::left, Align::left, Align::right, Align::right, Align::left,
                   Align::right, Align::right});
  for (std::size_t q = 0; q < time.quantities.size(); ++q)
    for (const ModulatedLight& light : time.modulated) {
      if (light.frequency == 0) continue;
      const TimeQuantity& quantity = time.quantities[q];
      const double mean = std::abs(time.modulated.front().values[q]), amplitude = std::abs(light.values[q]);
      table.add_row({quantity.name, quantity.quantity, quantity.band, number(light.frequency),
                     number(amplitude), quantity.unit, number(phase_of(light.values[q])),
                     number(mean > 0 ? amplitude / mean : 0)});
    }
  return titled("modulated light", table);
}

std::string histories_text(const TimeResult& time) {
  if (time.histories.empty()) return "";
  double worst = 0;
  for (const std::vector<ValueInTime>& history : time.histories) {
    double largest = 0, error = 0;
    for (const ValueInTime& value : history) {
      largest = std::max(largest, std::abs(value.value));
      error = std::max(error, value.error);
    }
    if (largest > 0) worst = std::max(worst, error / largest);
  }
  return fmt::format(
      "\nhistories: {} numbers at {} times, see times.csv (the inversion leaves up to {:.2g} of a number's "
      "largest value)\n",
      time.histories.size(), time.histories.front().size(), worst);
}

}  // namespace

std::string time_text(const RunResult& result) {
  if (!result.time) return "";
  const TimeResult& time = *result.time;
  return modulated_text(time, result.input.time->unit) + histories_text(time) +
         fmt::format("  {} rates, at most {} sweeps each: estimated relative error {:.2g}{}\n", time.rates,
                     time.sweeps, time.residual, time.converged ? "" : ", NOT converged");
}

}  // namespace etendue
