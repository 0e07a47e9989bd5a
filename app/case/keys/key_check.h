// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/keys/value_check.h"
#include "app/case/toml/toml_node.h"

namespace etendue {

/// Compares a whole case with the declarations: keys that are unknown, misspelt, misplaced or missing, and
/// values that are not of the declared type or range. What is wrong is reported and marked.
void check_keys(TomlNode& root, Faults& faults);

/// Reports every key that nobody has asked for.
void report_unused(TomlNode& root, Faults& faults);

}  // namespace etendue
