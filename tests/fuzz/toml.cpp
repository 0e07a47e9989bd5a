// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstdint>
#include <cstdlib>

#include "app/case/toml/render_toml.h"
#include "app/case/toml/toml_document.h"
#include "base/errors.h"

/// A case file that is TOML is written as a text that is read again as the same; what is not TOML is refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string once =
        etendue::render_toml(etendue::parse_toml({reinterpret_cast<const char*>(data), size}, "case.toml"));
    const std::string again = etendue::render_toml(etendue::parse_toml(once, "case.toml"));
    if (again != once) std::abort();
  } catch (const etendue::InputError&) {
  }
  return 0;
}
