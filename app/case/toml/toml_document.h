// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "app/case/toml/toml_node.h"

namespace etendue {

/// A TOML file as a table in which every value knows its line. Throws FileError where the file cannot be
/// read, InputError with the line where it is not TOML.
TomlNode read_toml(const std::filesystem::path& file);

/// The same from text; `file` is for messages.
TomlNode parse_toml(std::string_view text, const std::string& file);

/// A single value, e.g. `[1, 2]`, with `origin`; empty where the text is not a TOML value.
std::optional<TomlNode> parse_toml_value(std::string_view text, const Origin& origin);

}  // namespace etendue
