// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/keys/value_check.h"
#include "app/case/toml/toml_node.h"

namespace etendue {

/// What stands for the file in the origin of values from the command line.
inline constexpr const char* override_file = "--set";

/// Puts `key=value` of the command line into the case. The key is dotted; entries of lists are counted from
/// zero, `mesh.box[0].max` or `mesh.box.0.max`; parts with points are in quotes. The value is TOML, and
/// text where it is not.
void apply_override(TomlNode& root, const std::string& assignment, Faults& faults);

}  // namespace etendue
