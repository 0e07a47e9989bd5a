// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/ranks/scratch_directory.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "base/errors.h"

namespace etendue {

ScratchDirectory::ScratchDirectory() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) throw FileError("TMPDIR", error.message());
  std::string name = (folder / "etendue-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw FileError(name, std::strerror(errno));
  path_ = name;
}

ScratchDirectory::~ScratchDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace etendue
