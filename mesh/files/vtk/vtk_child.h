// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>

namespace etendue {

/// Has VTK read a file or folder in a child process, as what is corrupt may break VTK down. Returns the bytes
/// that `read` wrote there. An InputError that `read` throws is thrown here, and one where the child breaks
/// down.
std::string read_in_child(const std::filesystem::path& path, const std::function<void(std::FILE*)>& read);

}  // namespace etendue
