// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/lamps/ldt_file.h"

#include "base/errors.h"
#include "tests/fuzz/check_light_table.h"
#include "tests/fuzz/input_file.h"

/// A lamp is read as a table of finite intensities over rising angles, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const etendue::test::InputFile file(data, size);
    etendue::test::check(etendue::read_ldt(file.path()));
  } catch (const etendue::InputError&) {
  } catch (const etendue::FileError&) {
  }
  return 0;
}
