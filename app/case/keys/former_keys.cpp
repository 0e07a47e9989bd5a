// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/former_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/case/keys/keys.h"
#include "app/case/keys/override.h"

namespace etendue {
namespace {

void add_tables(TomlNode& node, std::vector<TomlNode*>& tables) {
  if (node.is_table()) tables.push_back(&node);
  if (node.is_array())
    for (auto& item : node.array()) add_tables(*item, tables);
}

/// The tables of a case at a declared place; NAME is any name.
std::vector<TomlNode*> tables_at(TomlNode& root, std::string_view path) {
  std::vector<TomlNode*> tables = {&root};
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('.'), path.size());
    const std::string_view part = path.substr(0, end);
    path.remove_prefix(std::min(end + 1, path.size()));
    std::vector<TomlNode*> below;
    for (TomlNode* table : tables)
      for (auto& [name, node] : table->table().entries)
        if (part == "NAME" || part == name) add_tables(*node, below);
    tables = std::move(below);
  }
  return tables;
}

void rename(TomlTable& table, const KeyDeclaration& key, std::vector<std::string>& notes, Faults& faults) {
  const auto former = std::ranges::find(table.entries, key.former_name, &TomlEntry::key);
  if (former == table.entries.end()) return;
  const Origin origin = former->node->origin;
  notes.push_back(to_string(fault_at(
      origin, "", fmt::format("deprecated name; use {} (accepted until {})", key.name, former_names_until))));
  const auto present = std::ranges::find(table.entries, key.name, &TomlEntry::key);
  if (present == table.entries.end()) {
    former->key = key.name;
    return;
  }
  if (origin.file != override_file)
    report(*former->node, fmt::format("given beside {}, its new name; remove one of them", key.name), faults);
  const std::int64_t position = present->node->position;
  present->node = std::move(former->node);
  present->node->position = position;
  table.entries.erase(former);
}

}  // namespace

void rename_former_keys(TomlNode& root, std::vector<std::string>& notes, Faults& faults) {
  for (const KeyDeclaration& key : key_declarations())
    if (!key.former_name.empty())
      for (TomlNode* table : tables_at(root, key.table)) rename(table->table(), key, notes, faults);
}

}  // namespace etendue
