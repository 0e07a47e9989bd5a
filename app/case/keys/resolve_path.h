// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/case/toml/toml_node.h"

namespace etendue {

/// A path that the case names; one that the command line names is relative to the working directory.
std::filesystem::path resolve_path(const TomlNode& node, const std::filesystem::path& case_folder);

/// The same of a file that is read now. Throws FileError with the key where it cannot be opened.
std::filesystem::path readable_path(const TomlNode& node, const std::filesystem::path& case_folder);

}  // namespace etendue
