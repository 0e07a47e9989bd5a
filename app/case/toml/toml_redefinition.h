// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "app/case/toml/toml_place.h"

namespace etendue {

/// Beginning of the line that has a key or a table for the second time, where toml++ stops at `place`: on
/// this line, or at the one after it where a part of a table's name is a value.
TomlPlace redefinition_place(const TomlPlace& place);

/// Problem of a key or a table that the file has twice: the line of the first one, and a remedy. The text
/// before the line of `place` must be TOML. Empty where it is not found there.
std::string redefinition_problem(const TomlPlace& place);

}  // namespace etendue
