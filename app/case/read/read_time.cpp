// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_time.h"

#include <algorithm>
#include <functional>

#include "app/case/keys/case_tables.h"
#include "app/case/temperatures.h"

namespace etendue {
namespace {

/// Why light in time is not solved for beside something else in the case; empty where it is.
std::string conflict_of(const Case& input) {
  if (input.photons || input.radiosity)
    return "not by photons or radiosity in this version; use solve.method = \"auto\"";
  if (input.exact) return "not beside [exact]";
  if (input.accuracy) return "not beside [accuracy] in this version";
  if (has_temperatures(input)) return "not beside temperatures, which would change with time too";
  if (input.solve.positivity != Positivity::none)
    return "not with values kept positive (transforms are complex); use space.positivity = \"none\"";
  if (input.solve.method == Method::source_iteration && input.solve.acceleration == Acceleration::diffusion)
    return "not by source iteration with diffusion; use solve.method = \"auto\"";
  return "";
}

std::vector<double> read_rising(Section& section, const char* name) {
  std::vector<double> values;
  const TomlNode* list = section.find(name);
  if (list == nullptr) return values;
  for (const auto& item : list->array()) values.push_back(item->number());
  if (std::ranges::adjacent_find(values, std::greater_equal<>()) != values.end())
    section.fault(name, "must rise throughout");
  return values;
}

}  // namespace

void read_time(Section time, Case& result) {
  TimeCase read;
  read.origin = time.origin();
  time_table().read(time, read);
  read.modulation = read_rising(time, "modulation");
  read.times = read_rising(time, "times");
  if (!time.has("modulation") && !time.has("times"))
    time.fault("asks for nothing; give modulation, times or both");
  if (const std::string conflict = conflict_of(result); !conflict.empty()) time.fault(conflict);
  result.time = std::move(read);
}

}  // namespace etendue
