// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/support/checkout.h"

namespace etendue::test {

std::string checkout(const std::string& name) { return ETENDUE_SOURCE_DIR "/" + name; }

}  // namespace etendue::test
