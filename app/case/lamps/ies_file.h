// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <istream>

#include "app/case/lamps/light_table.h"

namespace etendue {

/// Reads an IES file (ANSI/IESNA LM-63-02 and its forerunners) of photometric type A, B or C. A file of
/// TILT factors is looked for beside it.
/// Planes that the file leaves out because the lamp is symmetric are added. Throws InputError with the line.
LightTable read_ies(std::istream& stream, const std::filesystem::path& path);

}  // namespace etendue
