// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/case/lamps/light_table.h"

namespace etendue {

/// Reads an EULUMDAT file (Stockmar, Licht '90 (1990) 641-644) of any symmetry. Planes that the file leaves
/// out because the lamp is symmetric are added. Throws FileError, or InputError with the line.
LightTable read_ldt(const std::filesystem::path& path);

}  // namespace etendue
