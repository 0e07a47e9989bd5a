// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "base/errors.h"

namespace etendue {

/// The error of a file that a key names: `file:line: key = "name": problem; name a file that is there`
FileError unreadable_file(const Origin& key, const std::filesystem::path& path, std::string_view problem);

}  // namespace etendue
