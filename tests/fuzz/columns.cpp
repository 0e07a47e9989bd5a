// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/text/number_columns.h"

#include <cmath>
#include <cstdlib>

#include "base/errors.h"
#include "tests/fuzz/input_file.h"

/// Tables of numbers are read as finite columns of one length, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const etendue::test::InputFile file(data, size);
  try {
    const auto columns = etendue::read_columns(file.path(), {"angle", "value"});
    if (columns.size() != 2 || columns[0].size() != columns[1].size()) std::abort();
    for (const auto& column : columns)
      for (const double value : column)
        if (!std::isfinite(value)) std::abort();
  } catch (const etendue::InputError&) {
  }
  return 0;
}
