// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/case/keys/keys.h"
#include "app/case/toml/toml_node.h"
#include "base/vec3.h"
#include "solver/observe/color/white_balance.h"

namespace etendue {

// How members of these types are declared, read and written: the type of the key, the default as TOML, and
// the member from a value of that type.

constexpr KeyType key_type(double) { return KeyType::number; }
constexpr KeyType key_type(int) { return KeyType::integer; }
constexpr KeyType key_type(bool) { return KeyType::boolean; }
inline KeyType key_type(const std::string&) { return KeyType::text; }
inline KeyType key_type(const Vec3&) { return KeyType::point; }
inline KeyType key_type(const std::array<int, 2>&) { return KeyType::numbers; }
inline KeyType key_type(const White&) { return KeyType::choice_or_number; }

/// "1e6", "0.25", "2.0"
std::string to_toml(double value);
std::string to_toml(int value);
std::string to_toml(bool value);
std::string to_toml(const std::string& value);
std::string to_toml(const Vec3& value);
std::string to_toml(const std::array<int, 2>& value);
std::string to_toml(const White& value);

void take(const TomlNode& node, double& member);
void take(const TomlNode& node, int& member);
void take(const TomlNode& node, bool& member);
void take(const TomlNode& node, std::string& member);
void take(const TomlNode& node, Vec3& member);
/// Leaves the member as it is where the list is not one of two integers.
void take(const TomlNode& node, std::array<int, 2>& member);
void take(const TomlNode& node, White& member);

}  // namespace etendue
