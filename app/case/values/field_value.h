// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/case/keys/value_check.h"
#include "app/case/toml/toml_node.h"
#include "base/expression/formula.h"

namespace etendue {

/// Reads the file of a field, a table such as { file = "gas.vtu", array = "kappa" }, as a formula that calls
/// the field by the name `function`. Whatever is wrong becomes a fault.
std::optional<Formula> read_field_value(TomlNode& table, const std::string& function, Faults& faults);

}  // namespace etendue
