// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/compare/compare_table.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A page that needs no other file: the tables of a comparison, and slices through the middle of the domain
/// with the mean fluence of the cells by both methods and their difference in errors, side by side.
std::string comparison_page(const Comparison& comparison, const Problem& problem, const std::string& title,
                            const std::string& tables);

}  // namespace etendue
