// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

namespace etendue {

/// Throws InputError where a file is no unstructured grid, or counts more points or cells than it can hold:
/// VTK would not refuse it, or only after it took all memory.
void check_vtu_header(const std::filesystem::path& path);

}  // namespace etendue
