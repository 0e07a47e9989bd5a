// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cassert>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/case/keys/bound_value.h"
#include "app/case/keys/key_table.h"
#include "app/case/keys/section.h"

namespace etendue {

/// A member of a part of an object, as of the camera in a CameraCase.
template <class Object, class Part, class Member>
auto member_of(Part Object::*part, Member part_member) {
  return [ part, part_member ](auto& object) -> auto& { return std::invoke(part_member, object.*part); };
}

/// A table of the case file with keys that are bound to members of an Object. One declaration gives a key its
/// reader, default, place in the resolved case, line of the reference page and schema: its type is that of
/// the member; its default the member's own, unless the key is required, the member optional, or the default
/// described by `default_note`.
template <class Object>
class BoundTable : public KeyTable {
 public:
  /// `defaults` has the defaults of the keys.
  explicit BoundTable(std::string_view path, Object defaults = {})
      : KeyTable(path), defaults_(std::move(defaults)) {}

  using KeyTable::key;

  /// A key and its member: a pointer to it, or member_of().
  template <class Get>
  requires std::is_invocable_v<Get, Object&>
  void key(std::string_view name, Get get, KeyDetails details, std::string_view help) {
    using Member = std::remove_cvref_t<std::invoke_result_t<Get, Object&>>;
    const Member member = std::invoke(get, defaults_);
    if constexpr (requires {
                    typename Member::value_type;
                    member.has_value();
                  }) {
      KeyTable::key(name, key_type(typename Member::value_type{}), std::move(details), help);
    } else {
      if (has_fixed_default(details)) details.default_value = to_toml(member);
      KeyTable::key(name, key_type(member), std::move(details), help);
    }
    bind(name, [get](const TomlNode& node, Object& object) { take_into(node, std::invoke(get, object)); });
  }

  /// A key whose texts stand for values of its member.
  template <class Get, class Value = std::remove_cvref_t<std::invoke_result_t<Get, Object&>>>
  void choice(std::string_view name, Get get,
              const std::type_identity_t<std::vector<std::pair<std::string, Value>>>& values,
              KeyDetails details, std::string_view help) {
    for (const auto& [text, value] : values) {
      details.choices.push_back(text);
      if (has_fixed_default(details) && details.default_value.empty() && value == std::invoke(get, defaults_))
        details.default_value = to_toml(text);
    }
    KeyTable::key(name, KeyType::text, std::move(details), help);
    bind(name, [get, values](const TomlNode& node, Object& object) {
      for (const auto& [text, value] : values)
        if (text == node.text()) std::invoke(get, object) = value;
    });
  }

  /// Reads all bound keys. One that is absent or faulty has its default, which is added to the section where
  /// nothing is there; without a fixed default its member stays as it is.
  void read(Section& section, Object& object) const {
    for (const Binding& binding : bindings_) read(section, binding, object);
  }

  /// Reads one bound key.
  void read(Section& section, std::string_view name, Object& object) const {
    const auto found = std::ranges::find(bindings_, name, &Binding::name);
    assert(found != bindings_.end());
    read(section, *found, object);
  }

 private:
  struct Binding {
    std::string_view name;
    std::function<void(const TomlNode&, Object&)> take;
  };

  static bool has_fixed_default(const KeyDetails& details) {
    return details.need != Need::required && details.default_note.empty();
  }

  template <class Member>
  static void take_into(const TomlNode& node, Member& member) {
    take(node, member);
  }
  template <class Member>
  static void take_into(const TomlNode& node, std::optional<Member>& member) {
    take(node, member.emplace());
  }

  static void read(Section& section, const Binding& binding, Object& object) {
    if (const TomlNode* node = section.find_or_default(binding.name)) binding.take(*node, object);
  }

  void bind(std::string_view name, std::function<void(const TomlNode&, Object&)> take) {
    bindings_.push_back({name, std::move(take)});
  }

  Object defaults_;
  std::vector<Binding> bindings_;
};

}  // namespace etendue
