// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/keys/value_check.h"
#include "app/case/toml/toml_node.h"

namespace etendue {

/// Gives every key that has its former name the name that is declared for it, and adds a line to `notes` for
/// each: file, line, both names. Both names in one table are a fault, unless the former one is an override:
/// that replaces the value of the file.
void rename_former_keys(TomlNode& root, std::vector<std::string>& notes, Faults& faults);

/// Compares a whole case with the declarations: keys that are unknown, misspelt, misplaced or missing, and
/// values that are not of the declared type or range. What is wrong is reported and marked.
void check_keys(TomlNode& root, Faults& faults);

/// Reports every key that nobody has asked for.
void report_unused(TomlNode& root, Faults& faults);

}  // namespace etendue
