// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/toml/toml_redefinition.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "base/text/trimmed.h"

namespace etendue {
namespace {

bool is_after(const toml::node& a, const toml::node& b) {
  const auto place = [](const toml::node& node) {
    return std::tuple(node.source().begin.line, node.source().begin.column);
  };
  return place(a) > place(b);
}

/// The table with a header of its own that was begun last.
void find_current(const toml::table& table, const toml::table*& current) {
  if (!table.is_inline() && is_after(table, *current)) current = &table;
  for (const auto& [key, node] : table) {
    if (const toml::table* below = node.as_table()) find_current(*below, current);
    if (const toml::array* list = node.as_array())
      for (const toml::node& entry : *list)
        if (const toml::table* below = entry.as_table()) find_current(*below, current);
  }
}

/// The parts of a dotted key at the beginning of a text, by toml++ itself.
std::vector<std::string> key_parts(std::string_view key) {
  std::vector<std::string> parts;
  try {
    const toml::table root = toml::parse(std::string(key) + " = 0");
    for (const toml::table* table = &root; table != nullptr && !table->empty();) {
      parts.emplace_back(table->begin()->first.str());
      table = table->begin()->second.as_table();
    }
  } catch (const toml::parse_error&) {
    parts.clear();
  }
  return parts;
}

/// A node that a dotted key leads to.
struct Met {
  const toml::node* node = nullptr;  ///< the first that is no table, or the last; null where there is none
  std::string name;                  ///< the part of the key that leads there
};

Met met_on(const std::vector<std::string>& parts, const toml::table& from) {
  const toml::node* node = &from;
  std::string name;
  for (const std::string& part : parts) {
    if (const toml::array* list = node->as_array(); list != nullptr && !list->empty())
      node = list->get(list->size() - 1);
    const toml::table* table = node->as_table();
    if (table == nullptr) break;
    node = table->get(part);
    if (node == nullptr) return {};
    name += (name.empty() ? "" : ".") + part;
  }
  return node == &from ? Met{} : Met{node, name};
}

std::string name_taken_problem(const std::string& name, bool is_list, const toml::node& before) {
  const auto line = before.source().begin.line;
  if (before.is_array_of_tables() || (before.is_array() && !is_list))
    return fmt::format("{} is a list of tables since line {}; write [[{}]] for each of them", name, line,
                       name);
  if (before.is_table() && is_list)
    return fmt::format("[{}] on line {} is a single table; write [[{}]] there too for one of several", name,
                       line, name);
  if (before.is_table())
    return fmt::format("the table {} is on line {} already; put all its keys in one place", name, line);
  return fmt::format("{} on line {} is a value, and cannot be a table too", name, line);
}

bool is_toml(std::string_view text) {
  try {
    [[maybe_unused]] const toml::table root = toml::parse(text);
    return true;
  } catch (const toml::parse_error&) {
    return false;
  }
}

std::size_t bytes_before_line(const TomlPlace& place) {
  return static_cast<std::size_t>(place.line.data() - place.text.data());
}

}  // namespace

TomlPlace redefinition_place(const TomlPlace& place) {
  const std::size_t begin = bytes_before_line(place);
  TomlPlace twice = begin == 0 || is_toml(place.text.substr(0, begin)) ? place : place.moved_to(begin - 1);
  twice.at = std::min(twice.line.find_first_not_of(" \t"), twice.line.size());
  return twice;
}

std::string redefinition_problem(const TomlPlace& place) {
  const std::string_view line = trimmed(place.line);
  const std::size_t begin = bytes_before_line(place);
  try {
    const toml::table root = toml::parse(place.text.substr(0, begin));
    if (line.starts_with('[')) {
      const bool is_list = line.starts_with("[[");
      const std::string name(trimmed(line.substr(is_list ? 2 : 1, line.find(']') - (is_list ? 2 : 1))));
      const Met before = met_on(key_parts(name), root);
      return before.node == nullptr ? "" : name_taken_problem(before.name, is_list, *before.node);
    }
    const toml::table* current = &root;
    find_current(root, current);
    const std::string name(trimmed(line.substr(0, line.find('='))));
    const Met before = met_on(key_parts(name), *current);
    if (before.node == nullptr) return "";
    const auto line_before = before.node->source().begin.line;
    if (before.node->is_table())
      return fmt::format("{} is a table since line {}, and cannot be a value too", before.name, line_before);
    if (before.name != name)
      return fmt::format("{} has a value on line {}, and cannot be a table too", before.name, line_before);
    return fmt::format("{} has a value on line {} already; remove one of them", name, line_before);
  } catch (const toml::parse_error&) {
    return "";
  }
}

}  // namespace etendue
