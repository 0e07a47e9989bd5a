// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "app/case/toml/toml_place.h"

namespace etendue {

/// Problem of a key or a table that the file has twice: the line of the first one, and a remedy. The text
/// before the line of `place` must be TOML. Empty where it is not found there.
std::string redefinition_problem(const TomlPlace& place);

}  // namespace etendue
