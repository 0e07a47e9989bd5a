// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "app/case/keys/keys.h"
#include "base/edit_distance.h"

namespace etendue {
namespace {

std::string type_column(KeyType type) {
  switch (type) {
    case KeyType::any:
      return "";
    case KeyType::text:
      return "text";
    case KeyType::number:
      return "number";
    case KeyType::integer:
      return "integer";
    case KeyType::boolean:
      return "true, false";
    case KeyType::switch_:
      return "\"auto\", true, false";
    case KeyType::point:
      return "[x, y, z]";
    case KeyType::points:
      return "list of [x, y, z]";
    case KeyType::texts:
      return "list of text";
    case KeyType::numbers:
      return "list of numbers";
    case KeyType::band_texts:
      return "text per band";
    case KeyType::band_numbers:
      return "number per band";
    case KeyType::band_values:
      return "number, formula or field per band";
    case KeyType::place_value:
      return "number, formula or field";
    case KeyType::size_bound:
      return "number or table NAME = number";
    case KeyType::named_integers:
      return "table NAME = integer";
    case KeyType::named_points:
      return "table NAME = [x, y, z]";
    case KeyType::choice_or_number:
      return "text or number";
    case KeyType::rotation:
      return "\"random\" or table of axis, angle";
    case KeyType::named_sides:
      return "table side = text";
  }
  return "";
}

std::string default_column(const KeyDeclaration& key) {
  if (key.need == Need::required) return "required";
  if (!key.default_note.empty()) return std::string(key.default_note);
  return key.default_value.empty() ? "" : fmt::format("`{}`", key.default_value);
}

std::string accepted_column(const KeyDeclaration& key) {
  if (key.support == Support::later) return "not in this version";
  std::vector<std::string> choices = key.choices;
  if (key.type == KeyType::choice_or_number) choices.push_back("a number " + key.range.text());
  std::string text = choices.empty() ? key.range.text() : enumerate(choices);
  if (!key.later.empty())
    text += fmt::format("{}not in this version: {}", text.empty() ? "" : "; ", enumerate(key.later));
  return text;
}

std::string row(const KeyDeclaration& key) {
  return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", key.name, type_column(key.type), key.unit,
                     default_column(key), accepted_column(key), key.help);
}

std::string section(const TableDeclaration& table) {
  const std::string title = table.path.empty() ? "Top of the file" : "`" + table_header(table.path) + "`";
  std::string text = fmt::format("\n## {}\n{}{}\n", title, table.help,
                                 table.support == Support::later ? " Not in this version." : "");
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
