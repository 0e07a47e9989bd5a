// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/files/mesh_file.h"

namespace etendue {

/// What reading a file says, with the folder left out of it; "no error" where it succeeds.
inline std::string read_message(const std::filesystem::path& path, const Origin& origin = {}) {
  std::string message = "no error";
  try {
    read_mesh(path, 1, origin);
  } catch (const InputError& error) {
    message = error.what();
  } catch (const FileError& error) {
    message = std::string("FileError ") + error.what();
  }
  const std::string folder = path.parent_path().string() + "/";
  for (auto at = message.find(folder); at != std::string::npos; at = message.find(folder))
    message.erase(at, folder.size());
  return message;
}

}  // namespace etendue
