// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text/edit_distance.h"

namespace etendue {
namespace {

struct TypeTexts {
  KeyType type;
  std::string_view accepted, column;
};

constexpr std::array type_texts = {
    TypeTexts{KeyType::any, "a value", ""},
    TypeTexts{KeyType::text, "text", "text"},
    TypeTexts{KeyType::number, "a number", "number"},
    TypeTexts{KeyType::integer, "an integer", "integer"},
    TypeTexts{KeyType::boolean, "true or false", "true, false"},
    TypeTexts{KeyType::switch_, "\"auto\", true or false", "\"auto\", true, false"},
    TypeTexts{KeyType::point, "a list of three numbers", "[x, y, z]"},
    TypeTexts{KeyType::points, "a list of points [x, y, z]", "list of [x, y, z]"},
    TypeTexts{KeyType::texts, "a list of text", "list of text"},
    TypeTexts{KeyType::numbers, "a list of numbers", "list of numbers"},
    TypeTexts{KeyType::band_texts, "text, or a list with one for each band", "text per band"},
    TypeTexts{KeyType::band_numbers, "a number, or a list with one for each band", "number per band"},
    TypeTexts{KeyType::band_values,
              "a number, a formula in x, y, z or { file, array }, or a list with one for each band",
              "number, formula or field per band"},
    TypeTexts{KeyType::place_value, "a number, a formula in x, y, z or { file, array }",
              "number, formula or field"},
    TypeTexts{KeyType::thermal_value, "a number, a formula in x, y, z, T or { file, array }",
              "number, formula in T too, or field"},
    TypeTexts{KeyType::size_bound, "a number, or a table of one for each region",
              "number or table NAME = number"},
    TypeTexts{KeyType::named_integers, "a table of integers", "table NAME = integer"},
    TypeTexts{KeyType::named_points, "a table of points [x, y, z]", "table NAME = [x, y, z]"},
    TypeTexts{KeyType::choice_or_number, "text or a number", "text or number"},
    TypeTexts{KeyType::rotation, "\"random\" or { axis = [x, y, z], angle = degrees }",
              "\"random\" or table of axis, angle"},
    TypeTexts{KeyType::named_sides, "a table of names for xmin, xmax, ymin, ymax, zmin, zmax",
              "table side = text"},
};

const TypeTexts& texts_of(KeyType type) { return *std::ranges::find(type_texts, type, &TypeTexts::type); }

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

std::string_view type_column(KeyType type) { return texts_of(type).column; }

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
  const std::string type(texts_of(key.type).accepted), range = key.range.text();
  if (range.empty()) return type;
  const bool compound = type.find(',') != std::string::npos || key.type == KeyType::numbers;
  return type + (compound ? ", each " : " ") + range;
}

std::string former_name_text(const KeyDeclaration& key) {
  if (key.former_name.empty()) return "";
  return fmt::format("Formerly `{}`, which is accepted until {}.", key.former_name, former_names_until);
}

}  // namespace etendue
