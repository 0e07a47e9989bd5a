// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "app/case/toml_place.h"

namespace etendue {

/// A key or a table that stands in the file twice: where it stood first, and what helps. The text before the
/// line of `place` must be TOML. Empty where it is not found there.
std::string redefinition_problem(const TomlPlace& place);

}  // namespace etendue
