// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/keys.h"

#include <fmt/format.h>

#include "base/edit_distance.h"

namespace etendue {
namespace {

std::string type_text(KeyType type) {
  switch (type) {
    case KeyType::any:
      return "a value";
    case KeyType::text:
      return "text";
    case KeyType::number:
      return "a number";
    case KeyType::integer:
      return "an integer";
    case KeyType::boolean:
      return "true or false";
    case KeyType::switch_:
      return "\"auto\", true or false";
    case KeyType::point:
      return "a list of three numbers";
    case KeyType::points:
      return "a list of points [x, y, z]";
    case KeyType::texts:
      return "a list of text";
    case KeyType::numbers:
      return "a list of numbers";
    case KeyType::band_texts:
      return "text, or a list with one for each band";
    case KeyType::band_numbers:
      return "a number, or a list with one for each band";
    case KeyType::band_values:
      return "a number, a formula in x, y, z or { file, array }, or a list with one for each band";
    case KeyType::place_value:
      return "a number, a formula in x, y, z or { file, array }";
    case KeyType::size_bound:
      return "a number, or a table of one for each region";
    case KeyType::named_integers:
      return "a table of integers";
    case KeyType::named_points:
      return "a table of points [x, y, z]";
    case KeyType::choice_or_number:
      return "text or a number";
    case KeyType::rotation:
      return "\"random\" or { axis = [x, y, z], angle = degrees }";
    case KeyType::named_sides:
      return "a table of names for xmin, xmax, ymin, ymax, zmin, zmax";
  }
  return "";
}

std::vector<std::string> quoted_choices(const KeyDeclaration& key) {
  if (key.type == KeyType::integer) return key.choices;
  std::vector<std::string> result;
  for (const std::string& choice : key.choices) result.push_back('"' + choice + '"');
  return result;
}

// The part of a path after the last point, and what stands before it.
std::pair<std::string_view, std::string_view> split_path(std::string_view path) {
  const std::size_t point = path.rfind('.');
  if (point == std::string_view::npos) return {"", path};
  return {path.substr(0, point), path.substr(point + 1)};
}

}  // namespace

bool Range::holds(double number) const {
  return (lowest_excluded ? number > lowest : number >= lowest) &&
         (highest_excluded ? number < highest : number <= highest);
}

std::string Range::text() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::string low =
      lowest == -infinity ? "" : fmt::format("{} {}", lowest_excluded ? "above" : "at least", lowest);
  const std::string high =
      highest == infinity ? "" : fmt::format("{} {}", highest_excluded ? "below" : "at most", highest);
  if (low.empty() || high.empty()) return low + high;
  if (!lowest_excluded && !highest_excluded) return fmt::format("from {} to {}", lowest, highest);
  return low + " and " + high;
}

const KeyDeclaration* find_key(std::string_view table, std::string_view name) {
  for (const KeyDeclaration& key : key_declarations())
    if (key.table == table && key.name == name) return &key;
  return nullptr;
}

const TableDeclaration* find_table(std::string_view path) {
  for (const TableDeclaration& table : table_declarations())
    if (table.path == path) return &table;
  return nullptr;
}

std::vector<std::string> names_in(std::string_view table) {
  std::vector<std::string> names;
  for (const KeyDeclaration& key : key_declarations())
    if (key.table == table) names.emplace_back(key.name);
  for (const TableDeclaration& declared : table_declarations()) {
    const auto [parent, name] = split_path(declared.path);
    if (parent == table && !name.empty() && name != "NAME" && declared.path != field_table)
      names.emplace_back(name);
  }
  return names;
}

std::string table_header(std::string_view path) {
  if (path.empty()) return "the top of the file, above the first table";
  const TableDeclaration* table = find_table(path);
  const bool list = table != nullptr && table->form == TableForm::list;
  return list ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
}

std::string accepted_text(const KeyDeclaration& key) {
  if (!key.choices.empty()) {
    std::vector<std::string> choices = quoted_choices(key);
    if (key.type == KeyType::choice_or_number) choices.push_back("a number " + key.range.text());
    return enumerate(choices);
  }
  const std::string type = type_text(key.type), range = key.range.text();
  if (range.empty()) return type;
  const bool compound = type.find(',') != std::string::npos || key.type == KeyType::numbers;
  return type + (compound ? ", each " : " ") + range;
}

}  // namespace etendue
