// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/check_heat_in_time.h"

#include <algorithm>

#include "app/case/temperatures.h"

namespace etendue {
namespace {

class HeatInTimeCheck {
 public:
  HeatInTimeCheck(const Case& input, std::vector<Fault>& faults) : input_(input), faults_(faults) {}

  void medium(const MediumCase& medium) {
    if (medium.follows_from_heat() && !medium.heat_capacity)
      refuse(medium.origin, "its temperature follows from heat and changes with time: give heat_capacity");
    storing(medium, medium.heat_capacity.has_value());
    course(medium.in_time, medium.heat_source.has_value(), "heat_source");
  }

  void wall(const WallCase& wall) {
    storing(wall, wall.heat_capacity && wall.iterates_temperature());
    course(wall.in_time, wall.heat_flux.has_value(), "heat_flux");
    if (wall.in_time && wall.beam)
      refuse(wall.in_time->origin, "not beside a beam (not in this version), which shines always");
  }

  void light(const LightCase& light) {
    if (light.in_time && !light.of_wall)
      refuse(light.in_time->origin,
             "not beside temperatures that change with time (not in this version): lights shine always");
  }

  bool found_storage() const { return found_storage_; }

 private:
  void refuse(const Origin& origin, const char* what) { faults_.push_back(fault_at(origin, "", what)); }

  template <class Entry>
  void storing(const Entry& entry, bool stores) {
    found_storage_ = found_storage_ || stores;
    if (stores && !entry.initial_temperature && !input_.initial)
      refuse(entry.origin, "needs initial_temperature, that at t = 0");
    if (!stores && entry.initial_temperature)
      refuse(entry.initial_temperature->origin, "is of no use without heat_capacity");
  }

  void course(const std::optional<InTime>& in_time, bool has_heat, const char* key) {
    if (!in_time) return;
    if (!has_heat)
      refuse(in_time->origin,
             "is of no use without heat_source or heat_flux: nothing else changes with time here");
    else if (in_time->kind == InTime::Kind::pulse)
      faults_.push_back(fault_at(in_time->origin, "\"pulse\"",
                                 std::string("not of ") + key + "; use a formula in t or a table"));
  }

  const Case& input_;
  std::vector<Fault>& faults_;
  bool found_storage_ = false;
};

/// Without time nothing is stored.
template <class Entry>
void check_steady(const Entry& entry, std::vector<Fault>& faults) {
  for (const auto* value : {&entry.heat_capacity, &entry.initial_temperature})
    if (*value)
      faults.push_back(
          fault_at((*value)->origin, "",
                   "is of no use in a case without [time]; add [time] with until, or leave it out"));
}

}  // namespace

void check_heat_in_time(const Case& input, std::vector<Fault>& faults) {
  if (!steps_temperatures(input)) {
    for (const auto& [name, medium] : input.media) check_steady(medium, faults);
    for (const auto& [name, wall] : input.walls) check_steady(wall, faults);
    return;
  }
  HeatInTimeCheck check(input, faults);
  for (const auto& [name, medium] : input.media) check.medium(medium);
  for (const auto& [name, wall] : input.walls) check.wall(wall);
  for (const LightCase& light : input.lights) check.light(light);
  if (!check.found_storage())
    faults.push_back(fault_at(input.time->origin, "",
                              "temperatures change with time where media or walls store heat; give them "
                              "heat_capacity"));
}

}  // namespace etendue
