// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/case/keys/section.h"
#include "solver/materials/surfaces/reflectance.h"
#include "solver/problem/bands.h"

namespace etendue {

/// A table [walls.NAME.glossy]: a reflectance for each band; those of equal bands are one. Empty where it is
/// faulty, which is reported. Files that it names are found beside the case.
std::vector<std::shared_ptr<const Reflectance>> read_glossy(Section glossy, const Bands& bands,
                                                            const std::filesystem::path& case_folder);

}  // namespace etendue
