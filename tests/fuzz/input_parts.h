// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "tests/mesh/files/scratch_folder.h"

namespace etendue::test {

inline constexpr std::string_view part_separator = "\n====\n";

/// The folder for the files of all inputs, removed when the program ends.
inline const ScratchFolder& input_folder() {
  static const ScratchFolder folder;
  return folder;
}

/// Writes the parts of an input, between separators, as files of these names. A part that is not there is no
/// file.
inline void write_parts(const std::uint8_t* data, std::size_t size,
                        std::initializer_list<const char*> names) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  bool is_there = true;
  for (const char* name : names) {
    if (!is_there) {
      std::filesystem::remove(input_folder().path() / name);
      continue;
    }
    const std::size_t end = rest.find(part_separator);
    input_folder().write(name, std::string(rest.substr(0, end)));
    is_there = end != std::string_view::npos;
    if (is_there) rest.remove_prefix(end + part_separator.size());
  }
}

}  // namespace etendue::test
