// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "app/case/keys/keys.h"
#include "base/text/edit_distance.h"

namespace etendue {
namespace {

std::string default_column(const KeyDeclaration& key) {
  if (key.need == Need::required) return "required";
  if (!key.default_note.empty()) return std::string(key.default_note);
  return key.default_value.empty() ? "" : fmt::format("`{}`", key.default_value);
}

std::string accepted_column(const KeyDeclaration& key) {
  std::vector<std::string> choices = key.choices;
  if (key.type == KeyType::choice_or_number) choices.push_back("a number " + key.range.text());
  std::string text = choices.empty() ? key.range.text() : enumerate(choices);
  if (!key.later.empty())
    text += fmt::format("{}not in this version: {}", text.empty() ? "" : "; ", enumerate(key.later));
  return text;
}

std::string row(const KeyDeclaration& key) {
  const std::string former = key.former_name.empty() ? "" : " " + former_name_text(key);
  return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", key.name, type_column(key.type), key.unit,
                     default_column(key), accepted_column(key), std::string(key.help) + former);
}

std::string section(const TableDeclaration& table) {
  const std::string title = table.path.empty() ? "Top of the file" : "`" + table_header(table.path) + "`";
  std::string text = fmt::format("\n## {}\n{}\n", title, table.help);
  std::string rows;
  for (const KeyDeclaration& key : key_declarations())
    if (key.table == table.path) rows += row(key);
  if (rows.empty()) return text;
  return text + "\n| key | type | unit | default | accepted | meaning |\n|---|---|---|---|---|---|\n" + rows;
}

}  // namespace

std::string key_reference() {
  std::string text =
      "# Keys of the case file\n\n"
      "Printed by `etendue keys`. NAME is a name of your choice, or \"*\" for all that have no entry of "
      "their\n"
      "own. A value per band is a number for all bands or a list with one for each. A formula is text in x, "
      "y, "
      "z.\n";
  for (const TableDeclaration& table : table_declarations()) text += section(table);
  return text;
}

}  // namespace etendue
