// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/case/keys/section.h"
#include "solver/problem/bands.h"

namespace etendue {

/// One band for each gray gas of `wsgg` or `k_distribution` in the table of bands; no names where they are
/// faulty.
Bands read_gas_bands(Section& bands, const std::filesystem::path& case_folder);

}  // namespace etendue
