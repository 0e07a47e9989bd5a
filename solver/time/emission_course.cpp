// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/emission_course.h"

namespace etendue {

EmissionCourses one_course(const Problem& problem, const Course& course) {
  return {{course},
          std::vector<std::size_t>(problem.media().size(), 0),
          std::vector<std::size_t>(problem.walls().size(), 0),
          std::vector<std::size_t>(problem.lights().size(), 0)};
}

}  // namespace etendue
