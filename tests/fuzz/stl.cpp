// SPDX-License-Identifier: AGPL-3.0-or-later
#include <string_view>

#include "base/errors.h"
#include "tests/fuzz/check_soup.h"
#include "tests/fuzz/input_file.h"

/// An ASCII STL file is read as triangles whose points and walls exist, or refused. What does not begin with
/// "solid" is binary.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (!std::string_view(reinterpret_cast<const char*>(data), size).starts_with("solid")) return -1;
  const etendue::test::InputFile file(data, size);
  try {
    etendue::test::check(etendue::read_ascii_stl(file.path()));
  } catch (const etendue::InputError&) {
  }
  return 0;
}
