// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/unreadable_file.h"

#include <string>

namespace etendue {

FileError unreadable_file(const Origin& key, const std::filesystem::path& path, std::string_view problem) {
  const Fault place{key.file, key.line, key.key + " = \"" + path.filename().string() + "\""};
  return {to_string(place), std::string(problem) + "; name a file that is there"};
}

}  // namespace etendue
