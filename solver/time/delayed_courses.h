// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/time/emission_course.h"
#include "solver/time/uncollided_in_time.h"

namespace etendue {

/// Factors of light along rays whose sources follow courses.
class DelayedCourses {
 public:
  /// The courses must outlive it.
  DelayedCourses(const UncollidedInTime& uncollided, const EmissionCourses& courses);

  /// At a time: f(t - delay), of pulses the mean from `begin` on.
  DelayFactors at(double begin, double t) const;
  /// The mean from `begin` to `end`.
  DelayFactors mean(double begin, double end) const;
  /// What the mean of this step and of the step before it, which begins at `before`, give at its end.
  DelayFactors extrapolated(double before, double begin, double end) const;

 private:
  const Course& course(std::size_t source) const { return courses_.courses[course_of_[source]]; }

  const EmissionCourses& courses_;
  std::vector<std::size_t> course_of_;  ///< [source]
};

/// The mean from `begin` to `end` of what follows a course and comes later by `delay`; of pulses their
/// integral over that time, divided by it.
double mean_factor(const Course& course, double delay, double begin, double end);

}  // namespace etendue
