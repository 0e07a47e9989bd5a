// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/key_schema.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/case/keys/keys.h"

namespace etendue {
namespace {

using Json = nlohmann::ordered_json;

Json list_of(Json item) { return {{"type", "array"}, {"items", std::move(item)}}; }

Json one_of(std::vector<Json> kinds) { return {{"anyOf", std::move(kinds)}}; }

Json table_of(Json value) { return {{"type", "object"}, {"additionalProperties", std::move(value)}}; }

Json closed_table(Json properties) {
  return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

Json point() {
  return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}};
}

Json text_of(const KeyDeclaration& key) {
  Json text = {{"type", "string"}};
  if (!key.choices.empty()) text["enum"] = key.choices;
  return text;
}

Json json_number(const char* type, const Range& range) {
  Json number = {{"type", type}};
  if (std::isfinite(range.lowest))
    number[range.lowest_excluded ? "exclusiveMinimum" : "minimum"] = range.lowest;
  if (std::isfinite(range.highest))
    number[range.highest_excluded ? "exclusiveMaximum" : "maximum"] = range.highest;
  return number;
}

Json integer_of(const KeyDeclaration& key) {
  Json integer = json_number("integer", key.range);
  for (const std::string& choice : key.choices) integer["enum"].push_back(std::stoi(choice));
  return integer;
}

Json place_value(const Json& number) {
  return one_of({number, {{"type", "string"}}, {{"$ref", "#/definitions/field"}}});
}

Json per_band(const Json& value) { return one_of({value, list_of(value)}); }

Json names_of_sides() {
  Json names;
  for (const char* side : {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"})
    names[side] = {{"type", "string"}};
  return closed_table(names);
}

Json value_of(const KeyDeclaration& key) {
  const Json number = json_number("number", key.range);
  switch (key.type) {
    case KeyType::any:
      return Json::object();
    case KeyType::text:
      return text_of(key);
    case KeyType::number:
      return number;
    case KeyType::integer:
      return integer_of(key);
    case KeyType::boolean:
      return {{"type", "boolean"}};
    case KeyType::switch_:
      return {{"enum", Json::array({"auto", true, false})}};
    case KeyType::point:
      return point();
    case KeyType::points:
      return list_of(point());
    case KeyType::texts:
      return list_of(text_of(key));
    case KeyType::numbers:
      return list_of(number);
    case KeyType::band_texts:
      return per_band(text_of(key));
    case KeyType::band_numbers:
      return per_band(number);
    case KeyType::band_values:
      return per_band(place_value(number));
    case KeyType::place_value:
    case KeyType::thermal_value:
      return place_value(number);
    case KeyType::size_bound:
      return one_of({number, table_of(number)});
    case KeyType::named_integers:
      return table_of(integer_of(key));
    case KeyType::named_points:
      return table_of(point());
    case KeyType::choice_or_number:
      return one_of({text_of(key), number});
    case KeyType::rotation:
      return one_of(
          {{{"const", "random"}}, closed_table({{"axis", point()}, {"angle", {{"type", "number"}}}})});
    case KeyType::named_sides:
      return names_of_sides();
  }
  return Json::object();
}

Json described(const KeyDeclaration& key) {
  Json schema = value_of(key);
  std::string text(key.help);
  if (!key.unit.empty()) text += " Unit: " + std::string(key.unit) + ".";
  schema["description"] = text;
  // Defaults are TOML; the short ones are JSON as well.
  if (const Json value = Json::parse(key.default_value, nullptr, false); !value.is_discarded())
    schema["default"] = value;
  return schema;
}

/// The former name of a key.
Json deprecated(const KeyDeclaration& key) {
  Json schema = value_of(key);
  schema["description"] = "Deprecated name of " + std::string(key.name) + ", accepted until " +
                          std::string(former_names_until) + ".";
  schema["deprecated"] = true;
  return schema;
}

/// The name of a table directly within another one; empty of any other table.
std::string_view name_within(std::string_view parent, std::string_view path) {
  if (path.empty() || path == field_table) return {};
  if (!parent.empty()) {
    if (!path.starts_with(parent) || path.size() <= parent.size() || path[parent.size()] != '.') return {};
    path.remove_prefix(parent.size() + 1);
  }
  return path.find('.') == std::string_view::npos ? path : std::string_view{};
}

Json table_schema(const TableDeclaration& table);

/// The keys and the tables of a table.
Json contents_of(std::string_view path) {
  Json schema = closed_table(Json::object());
  for (const KeyDeclaration& key : key_declarations()) {
    if (key.table != path) continue;
    schema["properties"][std::string(key.name)] = described(key);
    if (!key.former_name.empty()) schema["properties"][std::string(key.former_name)] = deprecated(key);
    if (key.need == Need::required) schema["required"].push_back(key.name);
  }
  for (const TableDeclaration& table : table_declarations()) {
    const std::string_view name = name_within(path, table.path);
    if (name.empty()) continue;
    if (name == "NAME")
      schema["additionalProperties"] = table_schema(table);
    else
      schema["properties"][std::string(name)] = table_schema(table);
  }
  return schema;
}

Json table_schema(const TableDeclaration& table) {
  const Json contents = contents_of(table.path);
  Json schema = table.form == TableForm::table  ? contents
                : table.form == TableForm::list ? list_of(contents)
                                                : one_of({contents, list_of(contents)});
  schema["description"] = table.help;
  return schema;
}

}  // namespace

std::string key_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Case file of etendue"}};
  schema.update(contents_of(""));
  schema["definitions"]["field"] = contents_of(field_table);
  return schema.dump(2) + "\n";
}

}  // namespace etendue
