// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_accuracy.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/keys/case_tables.h"

namespace etendue {
namespace {

bool has_name(const auto& entries, std::string_view name) {
  return std::ranges::any_of(entries, [&](const auto& entry) { return entry.name == name; });
}

/// Of a probe, or of one of its points: NAME:INDEX.
std::string fault_of_probe(const std::string& name, const Case& input) {
  if (has_name(input.probes, name)) return "";
  const std::size_t colon = name.rfind(':');
  const auto probe = std::ranges::find(input.probes, name.substr(0, colon), &Probe::name);
  if (colon == std::string::npos || probe == input.probes.end())
    return fmt::format("the case has no probe \"{}\"", name);
  for (std::size_t i = 0; i < probe->points.size(); ++i)
    if (name.substr(colon + 1) == std::to_string(i)) return "";
  return fmt::format("its points are {}:0 to {}:{}", probe->name, probe->name, probe->points.size() - 1);
}

/// What is wrong with the name of a quantity; empty: nothing. Walls and regions are known with the mesh.
std::string fault_of_quantity(const std::string& quantity, const Case& input) {
  const std::size_t colon = quantity.find(':');
  const std::string kind = quantity.substr(0, colon);
  const std::string name = colon == std::string::npos ? "" : quantity.substr(colon + 1);
  if ((kind == "wall" || kind == "region") && !name.empty()) return "";
  if (kind == "sensor" && !name.empty())
    return has_name(input.sensors, name) ? "" : fmt::format("the case has no sensor \"{}\"", name);
  if (kind == "probe" && !name.empty()) return fault_of_probe(name, input);
  return "not known; use probe:NAME, sensor:NAME, wall:NAME or region:NAME";
}

}  // namespace

void read_accuracy(Section accuracy, bool sets_tolerance, Case& result) {
  AccuracyCase read;
  read.origin = accuracy.origin();
  read.sets_tolerance = sets_tolerance;
  accuracy_table().read(accuracy, read);
  if (accuracy.has("budget")) {
    Section budget = accuracy.section("budget");
    budget_table().read(budget, read);
  }
  if (accuracy.has("relative") == accuracy.has("absolute"))
    accuracy.fault("give one of relative and absolute, the largest error that a quantity may have");
  if (TomlNode* quantities = accuracy.find("of"))
    for (const auto& quantity : quantities->array()) {
      const std::string problem = fault_of_quantity(quantity->text(), result);
      if (!problem.empty())
        accuracy.faults().push_back(
            fault_at(quantity->origin, fmt::format("\"{}\"", quantity->text()), problem));
      read.of.push_back({quantity->text(), quantity->origin});
    }
  result.accuracy = std::move(read);
}

}  // namespace etendue
