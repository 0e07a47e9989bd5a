// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/delayed_courses.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>

namespace etendue {

namespace {

constexpr int intervals = 65536;

/// Of a path, all alike.
struct Delays {
  double middle, spread;
};

/// No light is there before it is sent.
Delays delays_of(const PathTime& path) {
  const double first = std::max(0.0, path.time - path.spread / 2), last = path.time + path.spread / 2;
  return {(first + last) / 2, last - first};
}

}  // namespace

CourseIntegral::CourseIntegral(const Course& course, double until)
    : course_(course), interval_(until / intervals), sums_(1, 0) {
  if (course.is_pulse) return;
  try {
    for (int k = 0; k < intervals; ++k)
      sums_.push_back(sums_.back() + interval_ * course.factor((k + 0.5) * interval_));
  } catch (const std::exception&) {
    // It is thrown again where that time is asked for.
  }
}

double CourseIntegral::until(double t) const {
  const double place = t / interval_;
  const auto k = static_cast<std::size_t>(place);
  if (k + 1 < sums_.size()) return std::lerp(sums_[k], sums_[k + 1], place - static_cast<double>(k));
  if (sums_.size() <= intervals) course_.factor((static_cast<double>(sums_.size()) - 0.5) * interval_);
  return sums_.back() + (t - interval_ * static_cast<double>(sums_.size() - 1)) * course_.factor(t);
}

double CourseIntegral::mean(double delay, double begin, double end) const {
  if (course_.is_pulse) return begin <= delay && delay < end ? 1 / (end - begin) : 0;
  if (end <= delay) return 0;
  return (until(end - delay) - until(std::max(begin, delay) - delay)) / (end - begin);
}

double CourseIntegral::mean(const PathTime& path, double begin, double end) const {
  const Delays delays = delays_of(path);
  if (course_.is_pulse && delays.spread > 0) {
    const double first = std::max(begin, delays.middle - delays.spread / 2),
                 last = std::min(end, delays.middle + delays.spread / 2);
    return std::max(0.0, last - first) / (delays.spread * (end - begin));
  }
  if (delays.spread == 0) return mean(delays.middle, begin, end);
  // Two points of Gauss and Legendre.
  const double aside = delays.spread / 2 * std::numbers::inv_sqrt3;
  return (mean(delays.middle - aside, begin, end) + mean(delays.middle + aside, begin, end)) / 2;
}

double CourseIntegral::at(const PathTime& path, double t) const {
  const Delays delays = delays_of(path);
  if (delays.spread > 0) return mean(delays.middle, t - delays.spread / 2, t + delays.spread / 2);
  return delays.middle < t ? course_.factor(t - delays.middle) : 0;
}

DelayedCourses::DelayedCourses(const UncollidedInTime& uncollided, const EmissionCourses& courses,
                               double until) {
  for (const Course& course : courses.courses) integrals_.emplace_back(course, until);
  for (std::size_t source = 0; source < uncollided.lights().sources().size(); ++source)
    course_of_.push_back(uncollided.course_of(source, courses));
}

DelayFactors DelayedCourses::at(double begin, double t) const {
  return {1, 1, [this, begin, t](const PathTime& path, std::span<double> factors) {
            const CourseIntegral& own = integral(path.source);
            factors[0] = own.course().is_pulse ? own.mean(path, begin, t) : own.at(path, t);
          }};
}

DelayFactors DelayedCourses::mean(double begin, double end) const {
  return {1, 1, [this, begin, end](const PathTime& path, std::span<double> factors) {
            factors[0] = integral(path.source).mean(path, begin, end);
          }};
}

DelayFactors DelayedCourses::extrapolated(double before, double begin, double end) const {
  return {1, 1, [this, before, begin, end](const PathTime& path, std::span<double> factors) {
            const CourseIntegral& own = integral(path.source);
            factors[0] = 1.5 * own.mean(path, begin, end) - 0.5 * own.mean(path, before, begin);
          }};
}

}  // namespace etendue
