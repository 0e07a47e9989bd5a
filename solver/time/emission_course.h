// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "solver/problem/problem.h"

namespace etendue {

/// When a source emits.
struct Course {
  /// All at t = 0, and nothing later: the energy is the power times a unit of time.
  bool is_pulse = false;
  /// The part of the power that it has at times t > 0, where it is no pulse. Asked by several threads at a
  /// time.
  std::function<double(double t)> factor = {};
};

/// When all that emits in a problem does.
struct EmissionCourses {
  std::vector<Course> courses;
  std::vector<std::size_t> regions;  ///< [region] the course of its medium
  std::vector<std::size_t> walls;    ///< [wall]
  std::vector<std::size_t> lights;   ///< [light]
};

/// All that emits follows the same course.
EmissionCourses one_course(const Problem& problem, const Course& course);

}  // namespace etendue
