// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/case/in_time.h"
#include "app/case/keys/section.h"
#include "base/expression/expression.h"

namespace etendue {

/// The factor of a formula of a source at a time. Throws InputError where it is not finite, or below 0.
double formula_factor(const InTime& in_time, const Expression& formula, double t);

/// The part of its power that a source has at times t > 0: all of it after a step, and by what is no course.
/// Asked by several threads at a time. Throws as formula_factor() when it is asked.
std::function<double(double t)> factor_in_time(const InTime& in_time);

/// Reads "in_time" of a table; empty where it is absent or faulty.
std::optional<InTime> read_in_time(Section& section, const std::filesystem::path& case_folder);

}  // namespace etendue
