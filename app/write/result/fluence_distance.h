// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "solver/exact/exact_comparison.h"

namespace etendue {

/// How far the fluence of one fields.vtu is from that of another, relative to the norm of the other, [band]:
/// integrals by a rule of degree 5 in each cell of the other, whose points are looked up in the first. Where
/// a curved wall leaves points of one mesh outside the other, they are left out. Empty where one of the files
/// is not there or holds no fluence, or where they hold different bands.
std::vector<FluenceError> fluence_distance(const std::filesystem::path& fields,
                                           const std::filesystem::path& other);

}  // namespace etendue
