// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/case.h"

#include "base/errors.h"

/// A case is read or refused. What it names is not there.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    etendue::read_case_text({reinterpret_cast<const char*>(data), size}, "/nowhere/case.toml");
  } catch (const etendue::InputError&) {
  } catch (const etendue::FileError&) {
  }
  return 0;
}
