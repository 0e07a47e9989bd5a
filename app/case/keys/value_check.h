// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/keys/keys.h"
#include "app/case/toml/toml_node.h"

namespace etendue {

using Faults = std::vector<Fault>;

/// Reports what is wrong with a value, its lists and tables included, and marks it.
void check_value(TomlNode& node, const KeyDeclaration& key, Faults& faults);

/// Reports a problem of this value and marks it.
void report(TomlNode& node, const std::string& problem, Faults& faults);

}  // namespace etendue
