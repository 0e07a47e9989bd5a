// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/errors.h"
#include "base/vec3.h"

namespace etendue {

struct TomlNode;

/// One key of a table.
struct TomlEntry {
  std::string key;
  std::unique_ptr<TomlNode> node;
};

/// In the order of the file.
struct TomlTable {
  std::vector<TomlEntry> entries;
};

using TomlArray = std::vector<std::unique_ptr<TomlNode>>;

/// A date or time, which no key takes.
struct TomlDate {
  std::string text;
};

/// A value of a case file that knows where it stands.
struct TomlNode {
  std::variant<bool, std::int64_t, double, std::string, TomlDate, TomlArray, TomlTable> value;
  Origin origin;
  std::int64_t position = 0;  ///< orders the file's values; kept when a value is overridden
  bool faulty = false;        ///< reported already: readers treat it as absent
  bool asked = false;         ///< read by somebody; what nobody asks for is unused

  bool is_table() const { return std::holds_alternative<TomlTable>(value); }
  bool is_array() const { return std::holds_alternative<TomlArray>(value); }
  bool is_text() const { return std::holds_alternative<std::string>(value); }
  bool is_number() const {
    return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
  }
  TomlTable& table() { return std::get<TomlTable>(value); }
  const TomlTable& table() const { return std::get<TomlTable>(value); }
  TomlArray& array() { return std::get<TomlArray>(value); }
  const TomlArray& array() const { return std::get<TomlArray>(value); }
  const std::string& text() const { return std::get<std::string>(value); }
  bool is_table_list() const;
  double number() const;  ///< of an integer too

  /// The value of a key of this table; null where there is none.
  TomlNode* find(std::string_view key);
  const TomlNode* find(std::string_view key) const;
  /// Adds a key that is not there yet.
  TomlNode& add(std::string key, TomlNode node);
};

/// What kind of value it is, for people: "a number", "text", "a list", …
std::string kind_of(const TomlNode& node);
/// As TOML on one line.
std::string to_toml(const TomlNode& node);
/// The same, shortened to be quoted in a message; empty for tables and lists of them.
std::string brief_toml(const TomlNode& node);
/// A key as TOML writes it: bare or quoted.
std::string toml_key(std::string_view key);
/// `table.key`, or `key` alone at the root.
std::string dotted_key(std::string_view table, std::string_view key);
std::string dotted_key(std::string_view list, std::size_t index);  ///< `list[index]`

/// A list of three numbers.
Vec3 to_vec3(const TomlNode& node);

}  // namespace etendue
