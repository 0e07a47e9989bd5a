// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/app/case/case_text.h"

#include <stdlib.h>

#include <fstream>
#include <stdexcept>

namespace etendue {

TestFolder::TestFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "etendue-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TestFolder::~TestFolder() { std::filesystem::remove_all(path_); }

std::filesystem::path TestFolder::write(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return path_ / name;
}

Case case_of(const std::string& text, const Overrides& overrides) {
  const TestFolder folder;
  return read_case(folder.write("slab.toml", text), overrides);
}

std::string faults_of(const std::string& text, const Overrides& overrides) {
  const TestFolder folder;
  const std::filesystem::path file = folder.write("slab.toml", text);
  try {
    read_case(file, overrides);
    return "";
  } catch (const InputError& error) {
    std::string lines = error.what();
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at = lines.find(prefix); at != std::string::npos; at = lines.find(prefix))
      lines.erase(at, prefix.size());
    return lines;
  }
}

}  // namespace etendue
