// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/delayed_courses.h"

#include <algorithm>
#include <numbers>

namespace etendue {

double mean_factor(const Course& course, double delay, double begin, double end) {
  if (course.is_pulse) return begin <= delay && delay < end ? 1 / (end - begin) : 0;
  const double from = std::max(begin, delay);
  if (from >= end) return 0;
  // Two points of Gauss and Legendre.
  const double middle = (from + end) / 2 - delay, half = (end - from) / 2,
               point = half * std::numbers::inv_sqrt3;
  return half * (course.factor(middle - point) + course.factor(middle + point)) / (end - begin);
}

DelayedCourses::DelayedCourses(const UncollidedInTime& uncollided, const EmissionCourses& courses)
    : courses_(courses) {
  for (std::size_t source = 0; source < uncollided.lights().sources().size(); ++source)
    course_of_.push_back(uncollided.course_of(source, courses));
}

DelayFactors DelayedCourses::at(double begin, double t) const {
  return {
      1, 1, [this, begin, t](std::size_t source, double delay, std::span<double> factors) {
        const Course& own = course(source);
        factors[0] = own.is_pulse ? mean_factor(own, delay, begin, t) : delay < t ? own.factor(t - delay) : 0;
      }};
}

DelayFactors DelayedCourses::mean(double begin, double end) const {
  return {1, 1, [this, begin, end](std::size_t source, double delay, std::span<double> factors) {
            factors[0] = mean_factor(course(source), delay, begin, end);
          }};
}

DelayFactors DelayedCourses::extrapolated(double before, double begin, double end) const {
  return {1, 1, [this, before, begin, end](std::size_t source, double delay, std::span<double> factors) {
            factors[0] = 1.5 * mean_factor(course(source), delay, begin, end) -
                         0.5 * mean_factor(course(source), delay, before, begin);
          }};
}

}  // namespace etendue
