// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/csv/time_tables.h"

#include <fmt/format.h>

#include <iterator>

#include "app/write/csv/csv_field.h"

namespace etendue {
namespace {

/// quantity,name,band,
std::string labels_of(const TimeQuantity& quantity) {
  return fmt::format("{},{},{},", quantity.quantity, csv_field(quantity.name), csv_field(quantity.band));
}

}  // namespace

std::string frequency_csv(const RunResult& result) {
  const TimeResult& time = *result.time;
  std::string table = "quantity,name,band,frequency,amplitude,phase,modulation,unit\n";
  for (std::size_t q = 0; q < time.quantities.size(); ++q)
    for (const ModulatedLight& light : time.modulated) {
      const double mean = std::abs(time.modulated.front().values[q]), amplitude = std::abs(light.values[q]);
      table += labels_of(time.quantities[q]);
      fmt::format_to(std::back_inserter(table), "{},{},{},{},{}\n", light.frequency, amplitude,
                     phase_of(light.values[q]), mean > 0 ? amplitude / mean : 0,
                     csv_field(time.quantities[q].unit));
    }
  return table;
}

std::string times_csv(const RunResult& result) {
  const TimeResult& time = *result.time;
  std::string table = "quantity,name,band,t,value,error,unit\n";
  for (std::size_t q = 0; q < time.histories.size(); ++q)
    for (std::size_t i = 0; i < time.histories[q].size(); ++i) {
      const ValueInTime& value = time.histories[q][i];
      table += labels_of(time.quantities[q]);
      fmt::format_to(std::back_inserter(table), "{},{},{},{}\n", result.input.time->times[i], value.value,
                     value.error, csv_field(time.quantities[q].unit));
    }
  return table;
}

std::string steps_csv(const RunResult& result) {
  const StepsInTime& steps = *result.time->steps;
  std::string table = "quantity,name,band,t,value,error,unit\n";
  for (std::size_t q = 0; q < steps.quantities.size(); ++q)
    for (const StepInTime& step : steps.steps) {
      table += labels_of(steps.quantities[q]);
      fmt::format_to(std::back_inserter(table), "{:.12g},{},{},{}\n", step.end, step.values[q],
                     step.errors.empty() ? "" : fmt::format("{}", step.errors[q]),
                     csv_field(steps.quantities[q].unit));
    }
  return table;
}

std::string flight_times_csv(const RunResult& result) {
  const TimeResult& time = *result.time;
  std::string table = "quantity,name,band,mean,deviation,unit\n";
  for (std::size_t q = 0; q < time.flight_times.size(); ++q) {
    table += labels_of(time.quantities[q]);
    fmt::format_to(std::back_inserter(table), "{},{},{}\n", time.flight_times[q].mean,
                   time.flight_times[q].deviation, csv_field(result.input.time->unit));
  }
  return table;
}

}  // namespace etendue
