// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "base/errors.h"

namespace etendue {

/// Throws the InputError of a file whose content is wrong.
[[noreturn]] inline void refuse_file(const std::filesystem::path& path, const std::string& problem) {
  throw InputError(Fault{path.string(), 0, problem});
}

}  // namespace etendue
