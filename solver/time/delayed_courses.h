// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/time/emission_course.h"
#include "solver/time/uncollided_in_time.h"

namespace etendue {

/// Integrals of the factor of a course over time, from values in the middle of many even intervals: exact of
/// a step, and of anything else but for kinks and jumps within an interval.
class CourseIntegral {
 public:
  /// The course must outlive it.
  CourseIntegral(const Course& course, double until);

  const Course& course() const { return course_; }
  /// The mean from `begin` to `end` of light that comes later by `delay`; of pulses their integral over that
  /// time, divided by it. Throws what the factor throws in that time.
  double mean(double delay, double begin, double end) const;
  /// The mean of that over the times of a path.
  double mean(const PathTime& path, double begin, double end) const;
  /// At a time, as mean over the times of a path; not of pulses.
  double at(const PathTime& path, double t) const;

 private:
  double until(double t) const;

  const Course& course_;
  double interval_;
  std::vector<double> sums_;  ///< [interval] the integral up to its beginning; ends where the factor throws
};

/// Factors of light along rays whose sources follow courses.
class DelayedCourses {
 public:
  /// The courses, of which the factors are asked by several threads at a time, must outlive it; `until` is
  /// the last time that is asked for.
  DelayedCourses(const UncollidedInTime& uncollided, const EmissionCourses& courses, double until);

  /// At a time: f(t - delay), of pulses the mean from `begin` on.
  DelayFactors at(double begin, double t) const;
  /// The mean from `begin` to `end`.
  DelayFactors mean(double begin, double end) const;
  /// What the mean of this step and of the step before it, which begins at `before`, give at its end.
  DelayFactors extrapolated(double before, double begin, double end) const;

 private:
  const CourseIntegral& integral(std::size_t source) const { return integrals_[course_of_[source]]; }

  std::vector<CourseIntegral> integrals_;  ///< [course]
  std::vector<std::size_t> course_of_;     ///< [source]
};

}  // namespace etendue
