// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "solver/problem/problem.h"
#include "solver/time/emission_course.h"

namespace etendue {

/// When the sources of a problem emit, as its case says, for steps in time.
EmissionCourses emission_courses(const Case& input, const Problem& problem);

/// Throws InputError, naming each wall and beam that sends a pulse in: in steps it would last as long as one.
void refuse_pulses_through_walls(const Problem& problem, const EmissionCourses& courses);

}  // namespace etendue
