// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/key_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/case/keys/override.h"
#include "base/text/edit_distance.h"

namespace etendue {
namespace {

constexpr std::string_view any_name = "NAME";

std::string child_path(std::string_view table, std::string_view name) {
  return table.empty() ? std::string(name) : fmt::format("{}.{}", table, name);
}

bool takes_names(std::string_view table) { return find_table(child_path(table, any_name)) != nullptr; }

// "[media.NAME] (NAME: a region or "*")"
std::string place_text(std::string_view table) {
  const std::string header = table_header(table);
  if (table.starts_with("media.")) return header + " (NAME: a region or \"*\")";
  if (table.starts_with("walls.")) return header + " (NAME: a wall or \"*\")";
  return header;
}

// The other tables that take a key of this name.
std::vector<std::string> places_of(std::string_view name) {
  std::vector<std::string> places;
  for (const KeyDeclaration& key : key_declarations())
    if (key.name == name) places.push_back(place_text(key.table));
  for (const TableDeclaration& table : table_declarations()) {
    const std::size_t point = table.path.rfind('.');
    if (point != std::string_view::npos && table.path.substr(point + 1) == name)
      places.push_back(table_header(table.path));
  }
  return places;
}

std::vector<std::string> key_names() {
  std::vector<std::string> names;
  for (const KeyDeclaration& key : key_declarations()) names.emplace_back(key.name);
  return names;
}

std::string unknown_key_problem(std::string_view table, const std::string& name) {
  const std::vector<std::string> here = names_in(table), places = places_of(name);
  const std::string meant = closest_name(name, here);
  if (!places.empty())
    return fmt::format("misplaced key; \"{}\" belongs in {}{}", name, enumerate(places),
                       meant.empty() ? "" : fmt::format(" (or did you mean \"{}\"?)", meant));
  if (!meant.empty()) return fmt::format("unknown key; did you mean \"{}\"?", meant);
  const std::string elsewhere = closest_name(name, key_names());
  if (!elsewhere.empty())
    return fmt::format("unknown key; did you mean \"{}\", which belongs in {}?", elsewhere,
                       enumerate(places_of(elsewhere)));
  return fmt::format("unknown key; {} takes {}", table.empty() ? "a case" : table_header(table),
                     enumerate(here));
}

/// The walk over a case, beside its declarations.
class KeyCheck {
 public:
  explicit KeyCheck(Faults& faults) : faults_(faults) {}

  void table(TomlNode& node, std::string_view path) {
    for (auto& [name, child] : node.table().entries) entry(*child, path, name);
    if (!node.faulty) required(node, path);
  }

 private:
  void entry(TomlNode& node, std::string_view table, const std::string& name) {
    const std::string path = child_path(table, name);
    if (const KeyDeclaration* key = find_key(table, name)) return value(node, *key);
    const bool plain = name != any_name && path != field_table && name.find('.') == std::string::npos;
    if (plain && find_table(path) != nullptr) return subtable(node, path);
    if (takes_names(table)) return named(node, table, name);
    report(node, unknown_key_problem(table, name), faults_);
  }

  void value(TomlNode& node, const KeyDeclaration& key) {
    check_value(node, key, faults_);
    if (key.type != KeyType::band_values && key.type != KeyType::place_value &&
        key.type != KeyType::thermal_value)
      return;
    field(node);
    if (node.is_array())
      for (auto& item : node.array()) field(*item);
  }

  // A value that is read from a file.
  void field(TomlNode& node) {
    if (node.is_table()) table(node, field_table);
  }

  // A table of the user's naming, as [media.smoke].
  void named(TomlNode& node, std::string_view table, const std::string& name) {
    const std::string path = child_path(table, any_name);
    if (node.is_table()) return this->table(node, path);
    if (find_key(path, name) != nullptr)
      return report(node, fmt::format("misplaced key; \"{}\" belongs in {}", name, place_text(path)),
                    faults_);
    report(node, fmt::format("must not be {}; {} is a table", kind_of(node), table_header(path)), faults_);
  }

  void subtable(TomlNode& node, const std::string& path) {
    const TableDeclaration& declared = *find_table(path);
    if (node.is_array() && declared.form != TableForm::table) return list(node, path);
    if (node.is_table() && declared.form != TableForm::list) return table(node, path);
    report(node, fmt::format("must not be {}; write {}", kind_of(node), table_header(path)), faults_);
  }

  void list(TomlNode& node, const std::string& path) {
    for (auto& item : node.array()) {
      if (item->is_table())
        table(*item, path);
      else
        report(*item, fmt::format("must not be {}; write {}", kind_of(*item), table_header(path)), faults_);
    }
  }

  void required(const TomlNode& node, std::string_view path) {
    for (const KeyDeclaration& key : key_declarations())
      if (key.table == path && key.need == Need::required && node.find(key.name) == nullptr)
        missing(node, key.name, accepted_text(key));
  }

  void missing(const TomlNode& node, std::string_view name, std::string_view accepted) {
    Origin origin = node.origin;
    origin.key = dotted_key(node.origin.key, name);
    faults_.push_back(fault_at(origin, "", fmt::format("missing; {}", accepted)));
  }

  Faults& faults_;
};

void report_unused_in(TomlNode& node, Faults& faults) {
  if (node.faulty) return;
  if (!node.asked) return report(node, "unused; remove it", faults);
  if (node.is_table())
    for (auto& [name, child] : node.table().entries) report_unused_in(*child, faults);
  if (node.is_array())
    for (auto& child : node.array()) report_unused_in(*child, faults);
}

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

void check_keys(TomlNode& root, Faults& faults) { KeyCheck(faults).table(root, ""); }

void report_unused(TomlNode& root, Faults& faults) {
  for (auto& [name, child] : root.table().entries) report_unused_in(*child, faults);
}

}  // namespace etendue
