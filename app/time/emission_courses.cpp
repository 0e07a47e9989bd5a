// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/emission_courses.h"

#include <algorithm>
#include <utility>

#include "app/case/build/entry_of.h"
#include "app/case/values/in_time_value.h"
#include "solver/time/timed_sources.h"

namespace etendue {
namespace {

Course course_of(const InTime& in_time) {
  if (in_time.kind == InTime::Kind::pulse) return {true, {}};
  return {false, factor_in_time(in_time)};
}

/// The courses, each once.
class Courses {
 public:
  explicit Courses(const InTime& of_all) : of_all_(of_all) {}

  std::size_t number_of(const std::optional<InTime>& own) {
    const InTime& in_time = own ? *own : of_all_;
    const auto known = std::ranges::find(texts_, in_time.text);
    if (known != texts_.end()) return static_cast<std::size_t>(known - texts_.begin());
    texts_.push_back(in_time.text);
    courses_.push_back(course_of(in_time));
    return texts_.size() - 1;
  }
  std::vector<Course> take() && { return std::move(courses_); }

 private:
  const InTime& of_all_;
  std::vector<std::string> texts_;
  std::vector<Course> courses_;
};

/// A light that comes in by some walls has its name and theirs.
std::optional<InTime> course_of_light(const Case& input, const std::string& name) {
  for (const LightCase& light : input.lights)
    if (light.name == name) return light.in_time;
  for (const LightCase& light : input.lights)
    if (name.starts_with(light.name + " through ")) return light.in_time;
  return std::nullopt;
}

}  // namespace

EmissionCourses emission_courses(const Case& input, const Problem& problem) {
  Courses courses(input.time->in_time);
  EmissionCourses result;
  for (const std::string& region : problem.mesh().region_names())
    result.regions.push_back(courses.number_of(entry_of(input.media, region).in_time));
  for (const std::string& wall : problem.mesh().wall_names())
    result.walls.push_back(courses.number_of(entry_of(input.walls, wall).in_time));
  for (const Light& light : problem.lights())
    result.lights.push_back(courses.number_of(course_of_light(input, light.name)));
  result.courses = std::move(courses).take();
  return result;
}

void refuse_pulses_through_walls(const Problem& problem, const EmissionCourses& courses) {
  std::vector<Fault> faults;
  const auto refuse = [&](const Origin& origin, const std::string& what) {
    faults.push_back(fault_at(origin, "",
                              what +
                                  " sends a pulse in, which would last as long as a step; give it in_time = "
                                  "\"step\", a formula in t or a table, or use times in place of until"));
  };
  for (std::size_t w = 0; w < problem.walls().size(); ++w)
    if (courses.courses[courses.walls[w]].is_pulse && emits(problem.walls()[w]))
      refuse(problem.walls()[w].origin, "the wall " + problem.mesh().wall_names()[w]);
  for (std::size_t l = 0; l < problem.lights().size(); ++l)
    if (courses.courses[courses.lights[l]].is_pulse &&
        std::holds_alternative<BeamLight>(problem.lights()[l].kind))
      refuse(problem.lights()[l].origin, "the light " + problem.lights()[l].name);
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace etendue
