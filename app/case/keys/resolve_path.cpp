// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/resolve_path.h"

#include "app/case/keys/override.h"

namespace etendue {

std::filesystem::path resolve_path(const TomlNode& node, const std::filesystem::path& case_folder) {
  const std::filesystem::path path(node.text());
  return node.origin.file == override_file ? path : (case_folder / path).lexically_normal();
}

}  // namespace etendue
