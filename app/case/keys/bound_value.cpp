// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/bound_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace etendue {

std::string to_toml(double value) {
  if (value >= 1e4 && value == std::floor(value)) {
    int exponent = 0;
    double digits = value;
    for (; std::fmod(digits, 10) == 0; ++exponent) digits /= 10;
    if (digits < 10) return fmt::format("{}e{}", digits, exponent);
  }
  std::string text = fmt::format("{}", value);
  if (const std::size_t zero = text.find("e-0"); zero != std::string::npos) text.erase(zero + 2, 1);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string to_toml(int value) { return std::to_string(value); }
std::string to_toml(bool value) { return value ? "true" : "false"; }
std::string to_toml(const std::string& value) { return '"' + value + '"'; }
std::string to_toml(const Vec3& value) { return fmt::format("[{}, {}, {}]", value[0], value[1], value[2]); }
std::string to_toml(const std::array<int, 2>& value) { return fmt::format("[{}, {}]", value[0], value[1]); }

std::string to_toml(const White& value) {
  if (value.kind == White::Kind::black_body) return to_toml(value.kelvin);
  return value.kind == White::Kind::d65 ? "\"D65\"" : "\"equal\"";
}

void take(const TomlNode& node, double& member) { member = node.number(); }
void take(const TomlNode& node, int& member) { member = static_cast<int>(node.number()); }
void take(const TomlNode& node, bool& member) { member = std::get<bool>(node.value); }
void take(const TomlNode& node, std::string& member) { member = node.text(); }
void take(const TomlNode& node, Vec3& member) { member = to_vec3(node); }

void take(const TomlNode& node, std::array<int, 2>& member) {
  const TomlArray& items = node.array();
  const bool whole = std::ranges::all_of(
      items, [](const auto& item) { return std::holds_alternative<std::int64_t>(item->value); });
  if (whole && items.size() == 2)
    member = {static_cast<int>(items[0]->number()), static_cast<int>(items[1]->number())};
}

void take(const TomlNode& node, White& member) {
  if (node.is_number())
    member = {White::Kind::black_body, node.number()};
  else
    member = {node.text() == "D65" ? White::Kind::d65 : White::Kind::equal};
}

}  // namespace etendue
