// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/lamps/ies_file.h"

#include <sstream>

#include "base/errors.h"
#include "tests/fuzz/check_light_table.h"

/// A lamp is read as a table of finite intensities over rising angles, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
    etendue::test::check(etendue::read_ies(stream, "lamp.ies"));
  } catch (const etendue::InputError&) {
  } catch (const etendue::FileError&) {
  }
  return 0;
}
