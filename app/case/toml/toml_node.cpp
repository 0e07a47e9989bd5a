// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/toml/toml_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace etendue {
namespace {

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;  // which Clang 14 does not deduce itself

std::string number_text(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  std::string text = fmt::format("{}", number);
  // TOML tells a float from an integer by its point or exponent.
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string quoted_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += {'\\', c};
    else if (c == '\n')
      result += "\\n";
    else if (c == '\t')
      result += "\\t";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
    else
      result += c;
  }
  return result + '"';
}

std::string array_text(const TomlArray& array) {
  std::string text;
  for (const auto& item : array) text += (text.empty() ? "" : ", ") + to_toml(*item);
  return "[" + text + "]";
}

std::string table_text(const TomlTable& table) {
  std::string text;
  for (const auto& [key, node] : table.entries)
    text += (text.empty() ? " " : ", ") + toml_key(key) + " = " + to_toml(*node);
  return text.empty() ? "{}" : "{" + text + " }";
}

}  // namespace

bool TomlNode::is_table_list() const {
  return is_array() && !array().empty() &&
         std::all_of(array().begin(), array().end(), [](const auto& item) { return item->is_table(); });
}

double TomlNode::number() const {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<double>(value);
}

const TomlNode* TomlNode::find(std::string_view key) const {
  for (const TomlEntry& entry : table().entries)
    if (entry.key == key) return entry.node.get();
  return nullptr;
}

TomlNode* TomlNode::find(std::string_view key) {
  return const_cast<TomlNode*>(std::as_const(*this).find(key));
}

TomlNode& TomlNode::add(std::string key, TomlNode node) {
  assert(find(key) == nullptr);
  table().entries.push_back({std::move(key), std::make_unique<TomlNode>(std::move(node))});
  return *table().entries.back().node;
}

std::string kind_of(const TomlNode& node) {
  return std::visit(Overloaded{[](bool) -> std::string { return "true or false"; },
                               [](std::int64_t) -> std::string { return "an integer"; },
                               [](double) -> std::string { return "a number"; },
                               [](const std::string&) -> std::string { return "text"; },
                               [](const TomlDate&) -> std::string { return "a date or time"; },
                               [](const TomlArray&) -> std::string { return "a list"; },
                               [](const TomlTable&) -> std::string { return "a table"; }},
                    node.value);
}

std::string to_toml(const TomlNode& node) {
  return std::visit(Overloaded{[](bool flag) -> std::string { return flag ? "true" : "false"; },
                               [](std::int64_t integer) -> std::string { return fmt::format("{}", integer); },
                               [](double number) -> std::string { return number_text(number); },
                               [](const std::string& text) -> std::string { return quoted_text(text); },
                               [](const TomlDate& date) -> std::string { return date.text; },
                               [](const TomlArray& array) -> std::string { return array_text(array); },
                               [](const TomlTable& table) -> std::string { return table_text(table); }},
                    node.value);
}

std::string brief_toml(const TomlNode& node) {
  constexpr std::size_t longest = 60;  // a message stays on a line
  if (node.is_table() || node.is_table_list()) return "";
  std::string text = to_toml(node);
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not inside a UTF-8 code
  return text.substr(0, end) + "…";
}

std::string toml_key(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
  return bare ? std::string(key) : quoted_text(key);
}

std::string dotted_key(std::string_view table, std::string_view key) {
  return table.empty() ? toml_key(key) : std::string(table) + "." + toml_key(key);
}

std::string dotted_key(std::string_view list, std::size_t index) {
  return fmt::format("{}[{}]", list, index);
}

Vec3 to_vec3(const TomlNode& node) {
  const TomlArray& items = node.array();
  return {items[0]->number(), items[1]->number(), items[2]->number()};
}

}  // namespace etendue
