// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "app/case/keys/case_tables.h"
#include "app/case/temperatures.h"
#include "app/case/values/in_time_value.h"

namespace etendue {
namespace {

/// More would take years.
constexpr double most_steps = 1e7;
/// Times at which a formula is evaluated.
constexpr int looks_at_formula = 1000;

/// Why temperatures are not stepped in time; empty where they are.
std::string conflict_with_heat(const TimeCase& read) {
  if (!read.until || !read.modulation.empty() || !read.times.empty() || read.flight_times)
    return "the case has temperatures, which change by steps alone: give until, and leave modulation, times "
           "and flight_times out";
  if (read.speed) return "the case has temperatures, for which light arrives at once; leave speed out";
  if (read.unit != TimeCase{}.unit) return "temperatures change in seconds; leave unit out";
  if (read.in_time.kind != InTime::Kind::pulse)
    return "in_time of temperatures is that of a heat_source or heat_flux; give it to the medium or wall";
  return "";
}

/// Why light in time is not solved for beside something else in the case; empty where it is.
std::string conflict_of(const Case& input, const TimeCase& read) {
  if (input.radiosity) return "not by radiosity in this version; use solve.method = \"auto\"";
  if (has_temperatures(input) && input.photons)
    return "temperatures change with time by ordinates alone (not by photons in this version); use "
           "solve.method = \"auto\"";
  if (input.photons && (!read.modulation.empty() || read.until || read.flight_times))
    return "photons know `times` alone; leave modulation, until and flight_times out";
  if (input.exact) return "not beside [exact]";
  if (input.accuracy) return "not beside [accuracy] in this version";
  if (has_temperatures(input)) return conflict_with_heat(read);
  if (!read.speed) return "needs `speed`, that of light in the case's unit of length by the unit of time";
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

void check_steps(Section& time, const TimeCase& read) {
  const auto unused = [&](const char* key, bool is_asked) {
    if (!read.until && is_asked) time.unused(key, "there are no steps without `until`");
  };
  unused("step", read.step.has_value());
  unused("tolerance", read.tolerance.has_value());
  unused("method", read.method != StepMethod::sdirk2);
  unused("frames", read.frames > 0);
  if (read.until && read.step && *read.step > *read.until)
    time.fault("step", "is longer than until; use at most that");
  if (read.until && read.step && *read.until / *read.step > most_steps)
    time.fault("step",
               fmt::format("asks for {:.3g} steps up to until; use a longer one", *read.until / *read.step));
  if (read.tolerance && read.method == StepMethod::bdf2)
    time.fault("method", "takes even steps; leave tolerance out, or use sdirk2");
}

/// Frequencies and times of flight do not ask when sources emit.
void refuse_courses(Section& time, const TimeCase& read, const Case& input) {
  const char* why = "it is for `times` and `until`";
  if (read.in_time.kind != InTime::Kind::pulse) time.unused("in_time", why);
  for (const InTime& own : own_courses(input))
    time.faults().push_back(
        fault_at(own.origin, "\"" + own.text + "\"", std::string("is of no use: ") + why));
}

/// Refuses a formula that is not finite, or below 0, at one of some times up to `until`.
void check_formula(const InTime& in_time, double until, Faults& faults) {
  if (in_time.kind != InTime::Kind::formula) return;
  const Expression formula(Formula{in_time.text}, {"t"});
  try {
    for (int k = 1; k <= looks_at_formula; ++k)
      formula_factor(in_time, formula, until * k / looks_at_formula);
  } catch (const InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
  }
}

/// Inversion knows pulses and steps, and one of them alone.
void refuse_inversion(Section& time, const InTime& in_time) {
  if (!time.has("times")) return;
  time.faults().push_back(fault_at(in_time.origin, "\"" + in_time.text + "\"",
                                   "is not for `times`, which needs \"pulse\" or \"step\" in [time], for all "
                                   "sources; set time.in_time, or use steps (time.until)"));
}

}  // namespace

std::vector<InTime> own_courses(const Case& input) {
  std::vector<InTime> courses;
  const auto add = [&](const std::optional<InTime>& in_time) {
    if (in_time) courses.push_back(*in_time);
  };
  for (const auto& [name, medium] : input.media) add(medium.in_time);
  for (const auto& [name, wall] : input.walls) add(wall.in_time);
  for (const LightCase& light : input.lights)
    if (!light.of_wall) add(light.in_time);
  return courses;
}

void read_time(Section time, const std::filesystem::path& case_folder, Case& result) {
  TimeCase read;
  read.origin = time.origin();
  time_table().read(time, read);
  if (const std::optional<InTime> in_time = read_in_time(time, case_folder)) read.in_time = *in_time;
  read.modulation = read_rising(time, "modulation");
  read.times = read_rising(time, "times");
  if (!has_temperatures(result) && !time.has("modulation") && !time.has("times") && !time.has("until") &&
      !read.flight_times)
    time.fault("asks for nothing; give modulation, times, until or flight_times");
  check_steps(time, read);
  if (read.times.empty() && !read.until) refuse_courses(time, read, result);
  if (read.window != TimeCase{}.window && (read.times.empty() || read.in_time.kind != InTime::Kind::pulse))
    time.unused("window", "it is for `times` after a pulse");
  if (read.in_time.kind != InTime::Kind::pulse && read.in_time.kind != InTime::Kind::step)
    refuse_inversion(time, read.in_time);
  if (read.until) {
    check_formula(read.in_time, *read.until, time.faults());
    for (const InTime& own : own_courses(result)) check_formula(own, *read.until, time.faults());
  }
  for (const InTime& own : own_courses(result))
    if (own.text != read.in_time.text) refuse_inversion(time, own);
  if (const std::string conflict = conflict_of(result, read); !conflict.empty()) time.fault(conflict);
  result.time = std::move(read);
}

}  // namespace etendue
