// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <utility>

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
      "\nhistories: {} numbers at {} times, see times.csv ({} up to {:.2g} of a number's largest value)\n",
      time.histories.size(), time.histories.front().size(),
      time.rates > 0 ? "the inversion leaves" : "the standard error is", worst);
}

/// Of a step of temperatures, without a caution.
constexpr double largest_error = 0.02;

std::string steps_text(const StepsInTime& steps, const std::string& unit) {
  double shortest = 0, longest = 0, error = 0, last = 0;
  for (const StepInTime& step : steps.steps) {
    const double length = step.end - std::exchange(last, step.end);
    shortest = shortest > 0 ? std::min(shortest, length) : length;
    longest = std::max(longest, length);
    error = std::max(error, step.error);
  }
  const std::string lengths = longest - shortest > 1e-6 * longest
                                  ? fmt::format("{:.4g} to {:.4g} {}", shortest, longest, unit)
                                  : fmt::format("{:.4g} {}", longest, unit);
  return fmt::format("\nsteps: {} of {}, to {:.6g} {}: {} numbers, see steps.csv{}\n", steps.steps.size(),
                     lengths, last, unit, steps.quantities.size(),
                     steps.frames.empty()
                         ? ""
                         : fmt::format("; {} frames in {}.pvd", steps.frames.size(), steps.of)) +
         fmt::format(
             "  at most {} sweeps each; a step of first order would change the {} by up to {:.2g} of its "
             "largest\n  {} kept to {:.2g}\n",
             steps.sweeps, steps.of, error, steps.of == "fluence" ? "energy" : "heat", steps.imbalance()) +
         (steps.of == "temperature" && error > largest_error
              ? "caution: steps are so long that temperatures may be far off; give time.tolerance, or a "
                "shorter "
                "time.step\n"
              : "");
}

std::string flight_times_text(const TimeResult& time, const std::string& unit) {
  if (time.flight_times.empty()) return "";
  if (time.quantities.size() > longest_report_table)
    return fmt::format("\ntimes of flight: of {} numbers, see flight_times.csv\n", time.quantities.size());
  TextTable table(
      {"of", "quantity", "band", fmt::format("mean [{}]", unit), fmt::format("deviation [{}]", unit)},
      {Align::left, Align::left, Align::left, Align::right, Align::right});
  for (std::size_t q = 0; q < time.quantities.size(); ++q)
    table.add_row({time.quantities[q].name, time.quantities[q].quantity, time.quantities[q].band,
                   number(time.flight_times[q].mean), number(time.flight_times[q].deviation)});
  return titled("times of flight", table);
}

}  // namespace

std::string time_text(const RunResult& result) {
  if (!result.time) return "";
  const TimeResult& time = *result.time;
  std::string text = modulated_text(time, result.input.time->unit) + histories_text(time) +
                     flight_times_text(time, result.input.time->unit);
  if (time.rates > 0) text += fmt::format("  {} rates, at most {} sweeps each\n", time.rates, time.sweeps);
  if (time.steps) text += steps_text(*time.steps, result.input.time->unit);
  if (time.rates == 0 && !time.steps && time.flight_times.empty()) return text;
  return text + fmt::format("  estimated relative error of the iteration {:.2g}{}\n", time.residual,
                            time.converged ? "" : ", NOT converged");
}

}  // namespace etendue
