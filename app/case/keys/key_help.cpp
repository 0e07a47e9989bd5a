// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/key_help.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/case/keys/keys.h"
#include "base/errors.h"
#include "base/text/edit_distance.h"

namespace etendue {
namespace {

constexpr std::size_t help_columns = 100;

std::vector<std::string> components(std::string_view path) {
  std::vector<std::string> parts(1);
  for (const char c : path)
    if (c == '.')
      parts.emplace_back();
    else if (c != '[' && c != ']' && c != '"' && c != ' ')
      parts.back() += c;
  return parts;
}

/// NAME in a declared path is any name.
bool matches_path(std::string_view declared, const std::vector<std::string>& parts) {
  if (declared.empty()) return parts.empty();
  return std::ranges::equal(components(declared), parts,
                            [](const std::string& name, const std::string& given) {
                              return name == "NAME" ? !given.empty() : name == given;
                            });
}

/// In lines that begin with so many spaces.
std::string wrapped(std::string_view text, std::size_t indent) {
  std::string lines;
  std::size_t column = help_columns;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const bool fits = column + 1 + word.size() <= help_columns;
    if (!fits) lines += (lines.empty() ? "" : "\n") + std::string(indent, ' ');
    if (fits) lines += ' ';
    column = (fits ? column + 1 : indent) + word.size();
    lines += word;
  }
  return lines.empty() ? lines : lines + "\n";
}

std::string description(const KeyDeclaration& key) {
  std::string facts = accepted_text(key);
  if (!key.unit.empty()) facts += fmt::format(" [{}]", key.unit);
  if (key.need == Need::required) facts += "; required";
  if (!key.default_note.empty())
    facts += fmt::format("; default: {}", key.default_note);
  else if (!key.default_value.empty())
    facts += fmt::format("; default: {}", key.default_value);
  return fmt::format("  {}\n", key.name) + wrapped(facts, 6) + wrapped(key.help, 6) +
         wrapped(former_name_text(key), 6);
}

std::string description(const TableDeclaration& table) {
  std::string text = table_header(table.path) + "\n" + wrapped(table.help, 2);
  for (const KeyDeclaration& key : key_declarations())
    if (key.table == table.path) text += "\n" + description(key);
  std::vector<std::string> inside;
  for (const TableDeclaration& other : table_declarations())
    if (!table.path.empty() && other.path.starts_with(std::string(table.path) + "."))
      inside.push_back(table_header(other.path));
  if (!inside.empty())
    text += "\n" + wrapped("Tables in it: " + fmt::format("{}", fmt::join(inside, ", ")) + ".", 2);
  return text;
}

std::vector<std::string> key_and_table_names() {
  std::vector<std::string> names;
  for (const TableDeclaration& table : table_declarations()) names.emplace_back(table.path);
  for (const KeyDeclaration& key : key_declarations()) {
    names.emplace_back(key.name);
    names.push_back(fmt::format("{}.{}", key.table, key.name));
  }
  return names;
}

}  // namespace

std::string key_help(std::string_view path) {
  const std::vector<std::string> parts = components(path);
  std::vector<std::string> found;
  for (const TableDeclaration& table : table_declarations())
    if (matches_path(table.path, parts)) found.push_back(description(table));
  const std::vector<std::string> parents(parts.begin(), parts.end() - 1);
  for (const KeyDeclaration& key : key_declarations())
    if ((key.name == parts.back() || (!key.former_name.empty() && key.former_name == parts.back())) &&
        (parents.empty() || matches_path(key.table, parents)))
      found.push_back(table_header(key.table) + "\n" + description(key));
  if (found.empty())
    throw InputError(fmt::format("keys: {}: no such table or key{}; etendue keys lists all", path,
                                 suggestion(path, key_and_table_names())));
  return fmt::format("{}", fmt::join(found, "\n"));
}

}  // namespace etendue
