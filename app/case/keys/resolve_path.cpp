// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/resolve_path.h"

#include <fstream>

#include "app/case/keys/override.h"
#include "base/unreadable_file.h"

namespace etendue {

std::filesystem::path resolve_path(const TomlNode& node, const std::filesystem::path& case_folder) {
  const std::filesystem::path path(node.text());
  return node.origin.file == override_file ? path : (case_folder / path).lexically_normal();
}

std::filesystem::path readable_path(const TomlNode& node, const std::filesystem::path& case_folder) {
  std::filesystem::path path = resolve_path(node, case_folder);
  if (!std::ifstream(path)) throw unreadable_file(node.origin, path, path.string() + ": cannot be opened");
  return path;
}

}  // namespace etendue
