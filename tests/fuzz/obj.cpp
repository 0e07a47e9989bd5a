// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/errors.h"
#include "tests/fuzz/check_soup.h"
#include "tests/fuzz/input_file.h"

/// An OBJ file is read as polygons whose points and walls exist, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const etendue::test::InputFile file(data, size);
  try {
    etendue::test::check(etendue::read_obj(file.path()));
  } catch (const etendue::InputError&) {
  }
  return 0;
}
