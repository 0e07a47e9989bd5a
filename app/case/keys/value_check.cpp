// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/keys/value_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/edit_distance.h"

namespace etendue {
namespace {

// Beyond this, volumes and powers overflow.
constexpr double largest_number = 1e60;

std::string meant(std::string_view misspelt, std::span<const std::string> names) {
  const std::string name = closest_name(misspelt, names);
  return name.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", name);
}

/// The checks of one value; each returns whether the value is sound.
class ValueCheck {
 public:
  ValueCheck(const KeyDeclaration& key, Faults& faults) : key_(key), faults_(faults) {}

  bool value(TomlNode& node) {
    switch (key_.type) {
      case KeyType::any:
        return true;
      case KeyType::text:
        return chosen_text(node);
      case KeyType::number:
        return number(node);
      case KeyType::integer:
        return integer(node);
      case KeyType::boolean:
        return std::holds_alternative<bool>(node.value) || wrong_type(node);
      case KeyType::switch_:
        return switch_value(node);
      case KeyType::point:
        return point(node);
      case KeyType::points:
        return list(node, &ValueCheck::point);
      case KeyType::texts:
        return list(node, &ValueCheck::text);
      case KeyType::numbers:
        return list(node, &ValueCheck::number);
      case KeyType::band_texts:
        return node.is_array() ? list(node, &ValueCheck::chosen_text) : chosen_text(node);
      case KeyType::band_numbers:
        return node.is_array() ? list(node, &ValueCheck::number) : number(node);
      case KeyType::band_values:
        return node.is_array() ? list(node, &ValueCheck::number_or_formula) : number_or_formula(node);
      case KeyType::place_value:
      case KeyType::thermal_value:
        return number_or_formula(node);
      case KeyType::size_bound:
        return node.is_table() ? names(node, &ValueCheck::number) : number(node);
      case KeyType::named_integers:
        return names(node, &ValueCheck::integer);
      case KeyType::named_points:
        return names(node, &ValueCheck::point);
      case KeyType::choice_or_number:
        return node.is_text() ? chosen_text(node) : number(node);
      case KeyType::rotation:
        return rotation(node);
      case KeyType::named_sides:
        return sides(node);
    }
    return true;
  }

 private:
  using Check = bool (ValueCheck::*)(TomlNode&);

  bool fail(TomlNode& node, const std::string& problem) {
    report(node, problem, faults_);
    return false;
  }

  bool wrong_type(TomlNode& node) {
    std::string hint;
    if (key_.type == KeyType::integer && node.is_number()) hint = " without a decimal point";
    if (node.is_text() && !key_.unit.empty())
      hint = fmt::format(" in {} (units are set in [units])", key_.unit);
    return fail(node, fmt::format("must not be {}; use {}{}", kind_of(node), accepted_text(key_), hint));
  }

  bool text(TomlNode& node) {
    if (!node.is_text()) return wrong_type(node);
    const bool may_be_empty = key_.default_value == "\"\"";
    return !node.text().empty() || may_be_empty || fail(node, "must not be empty");
  }

  bool number(TomlNode& node) {
    if (!node.is_number()) return wrong_type(node);
    const double value = node.number();
    if (!std::isfinite(value)) return fail(node, "must be a finite number; use " + accepted_text(key_));
    if (!key_.range.holds(value)) return fail(node, "out of range; use " + accepted_text(key_));
    if (std::abs(value) > largest_number)
      return fail(node, fmt::format("too large (powers and volumes would overflow); use numbers up to {:.0e}",
                                    largest_number));
    return true;
  }

  bool integer(TomlNode& node) {
    if (!std::holds_alternative<std::int64_t>(node.value)) return wrong_type(node);
    return choice(node, to_toml(node)) && number(node);
  }

  bool chosen_text(TomlNode& node) { return text(node) && choice(node, node.text()); }

  // A field is a table with keys of its own.
  bool number_or_formula(TomlNode& node) {
    if (node.is_table()) return true;
    return node.is_text() ? text(node) : number(node);
  }

  bool switch_value(TomlNode& node) {
    const bool known = std::holds_alternative<bool>(node.value) || (node.is_text() && node.text() == "auto");
    return known ? choice(node, to_toml(node)) : wrong_type(node);
  }

  bool choice(TomlNode& node, const std::string& text) {
    if (std::ranges::count(key_.later, text) > 0)
      return fail(node, "not in this version; use " + accepted_text(key_));
    if (key_.choices.empty() || std::ranges::count(key_.choices, text) > 0) return true;
    return fail(node, fmt::format("is not known{}; use {}", meant(text, key_.choices), accepted_text(key_)));
  }

  bool point(TomlNode& node) {
    if (!node.is_array()) return wrong_type(node);
    if (node.array().size() != 3)
      return fail(node, fmt::format("has {} entries; use a list of three numbers", node.array().size()));
    return list(node, &ValueCheck::number);
  }

  bool list(TomlNode& node, Check check) {
    if (!node.is_array()) return wrong_type(node);
    if (node.array().empty()) return fail(node, "is empty; use " + accepted_text(key_));
    bool sound = true;
    for (auto& item : node.array()) sound = (this->*check)(*item) && sound;
    node.faulty = !sound;
    return sound;
  }

  bool names(TomlNode& node, Check check) {
    if (!node.is_table()) return wrong_type(node);
    bool sound = true;
    for (auto& [name, item] : node.table().entries) sound = (this->*check)(*item) && sound;
    node.faulty = !sound;
    return sound;
  }

  bool rotation(TomlNode& node) {
    if (node.is_text() && node.text() == "random") return true;
    const TomlNode* axis = node.is_table() ? node.find("axis") : nullptr;
    const TomlNode* angle = node.is_table() ? node.find("angle") : nullptr;
    if (axis == nullptr || angle == nullptr || node.table().entries.size() != 2)
      return fail(node, fmt::format("is no rotation; use {}", accepted_text(key_)));
    bool sound = number(*node.find("angle"));
    sound = point(*node.find("axis")) && sound;
    node.faulty = !sound;
    if (sound && to_vec3(*axis).squaredNorm() == 0)
      return fail(node, "its axis has no direction; use a vector that is not zero");
    return sound;
  }

  bool sides(TomlNode& node) {
    static const std::vector<std::string> known = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
    if (!names(node, &ValueCheck::text)) return false;
    for (auto& [name, item] : node.table().entries) {
      if (std::ranges::count(known, name) > 0) continue;
      fail(*item, fmt::format("unknown side{}; use {}", meant(name, known), enumerate(known)));
      node.faulty = true;
    }
    return !node.faulty;
  }

  const KeyDeclaration& key_;
  Faults& faults_;
};

}  // namespace

void report(TomlNode& node, const std::string& problem, Faults& faults) {
  node.faulty = true;
  faults.push_back(fault_at(node.origin, brief_toml(node), problem));
}

void check_value(TomlNode& node, const KeyDeclaration& key, Faults& faults) {
  if (!ValueCheck(key, faults).value(node)) node.faulty = true;
}

}  // namespace etendue
