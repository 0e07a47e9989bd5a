// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/toml/render_toml.h"

#include <algorithm>

namespace etendue {
namespace {

// Tables below [table.name] are written inline.
constexpr int deepest_header = 2;

/// A table that gets a header of its own.
struct Headed {
  std::string header;
  std::string key;
  const TomlNode* node;
};

std::vector<Headed> headed_tables(const TomlNode& table, const std::string& key) {
  std::vector<Headed> headed;
  for (const auto& [name, node] : table.table().entries) {
    const std::string child = dotted_key(key, name);
    if (node->is_table()) headed.push_back({"[" + child + "]", child, node.get()});
    if (node->is_table_list())
      for (const auto& item : node->array()) headed.push_back({"[[" + child + "]]", child, item.get()});
  }
  std::ranges::stable_sort(headed, {}, [](const Headed& item) { return item.node->position; });
  return headed;
}

// The values of the table itself.
std::string values_text(const TomlNode& table, bool inline_below) {
  std::string text;
  for (const auto& [name, node] : table.table().entries)
    if (inline_below || !(node->is_table() || node->is_table_list()))
      text += toml_key(name) + " = " + to_toml(*node) + "\n";
  return text;
}

std::string tables_text(const TomlNode& table, const std::string& key, int depth) {
  std::string text;
  for (const Headed& item : headed_tables(table, key)) {
    const bool inline_below = depth >= deepest_header;
    const std::string values = values_text(*item.node, inline_below);
    const std::string below = inline_below ? "" : tables_text(*item.node, item.key, depth + 1);
    // A header that only other headers follow says nothing.
    if (!values.empty() || below.empty()) text += "\n" + item.header + "\n" + values;
    text += below;
  }
  return text;
}

}  // namespace

std::string render_toml(const TomlNode& root) { return values_text(root, false) + tables_text(root, "", 1); }

}  // namespace etendue
