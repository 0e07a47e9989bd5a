// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/render_toml.h"

#include <algorithm>

namespace etendue {
namespace {

// Tables below [table.name] are written inline.
constexpr int deepest_header = 2;

bool is_table_list(const TomlNode& node) {
  return node.is_array() && !node.array().empty() &&
         std::ranges::all_of(node.array(), [](const auto& item) { return item->is_table(); });
}

/// A table that gets a header of its own.
struct Headed {
  std::string header;
  std::string key;
  const TomlNode* node;
};

std::string table_text(const TomlNode& table, const std::string& key, int depth);

std::vector<Headed> headed_tables(const TomlNode& table, const std::string& key) {
  std::vector<Headed> headed;
  for (const auto& [name, node] : table.table().entries) {
    const std::string child = dotted_key(key, name);
    if (node->is_table()) headed.push_back({"[" + child + "]", child, node.get()});
    if (is_table_list(*node))
      for (const auto& item : node->array()) headed.push_back({"[[" + child + "]]", child, item.get()});
  }
  std::ranges::stable_sort(headed, {}, [](const Headed& item) { return item.node->position; });
  return headed;
}

std::string table_text(const TomlNode& table, const std::string& key, int depth) {
  std::string text;
  const bool inline_below = depth >= deepest_header;
  for (const auto& [name, node] : table.table().entries)
    if (inline_below || !(node->is_table() || is_table_list(*node)))
      text += toml_key(name) + " = " + to_toml(*node) + "\n";
  if (inline_below) return text;
  for (const Headed& item : headed_tables(table, key))
    text += "\n" + item.header + "\n" + table_text(*item.node, item.key, depth + 1);
  return text;
}

}  // namespace

std::string render_toml(const TomlNode& root) { return table_text(root, "", 0); }

}  // namespace etendue
