// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/toml/toml_node.h"

namespace etendue {

/// A whole case as TOML, a line for each value: [table], [[list]], and inline tables below them. Lists of
/// tables are in the order of the file, since later primitives overwrite earlier ones.
std::string render_toml(const TomlNode& root);

}  // namespace etendue
