// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Files of the checkout that tests read.
#pragma once

#include <string>

namespace etendue::test {

/// The file of this name, e.g. "cases/room/case.toml", in the checkout that the tests were built from.
std::string checkout(const std::string& name);

}  // namespace etendue::test
