// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/case/case.h"
#include "app/case/keys/section.h"
#include "solver/problem/bands.h"

namespace etendue {

/// One band for each gray gas of `wsgg` or `k_distribution` in the table of bands; no names where they are
/// faulty. Where the molar ratio is one of the place they are those of a ratio of 1.
Bands read_gas_bands(Section& bands, const std::filesystem::path& case_folder,
                     const std::optional<BandValues>& molar_ratio);

}  // namespace etendue
