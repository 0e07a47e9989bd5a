// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/case/keys/value_check.h"
#include "app/case/toml/toml_node.h"

namespace etendue {

/// A table of the case as a reader sees it: checked values, declared defaults for those that are absent or
/// faulty. Asking marks a value as used, and a default that is asked for is added to the table, so that in
/// the end the table is the resolved case.
class Section {
 public:
  /// `path` is the table's place among the declarations, e.g. "media.NAME".
  Section(TomlNode& table, std::string path, Faults& faults);

  /// Whether the key is there, sound or not.
  bool has(std::string_view name) const { return table_.find(name) != nullptr; }
  /// The value if it is there and sound, else null. No default.
  TomlNode* find(std::string_view name);

  /// The sound value or the declared default, which is added where nothing is there; null without both.
  const TomlNode* find_or_default(std::string_view name);

  std::optional<std::string> text_if(std::string_view name);
  std::optional<double> number_if(std::string_view name);
  std::optional<Vec3> point_if(std::string_view name);
  /// The sound value, or the declared default, which is added where nothing is there. Throws InputError with
  /// all faults so far where the key has no default: its fault is among them, and reading ends. The
  /// reference stays valid as long as this section.
  const TomlNode& value(std::string_view name);
  // The same, by type.
  std::string text(std::string_view name);
  double number(std::string_view name);
  int integer(std::string_view name);
  bool boolean(std::string_view name);
  std::vector<std::string> texts(std::string_view name);

  /// Writes a default that is not declared as a fixed value into the resolved case.
  void resolve(std::string_view name, std::string value);

  /// A table in this one; made where it is absent.
  Section section(std::string_view name);
  /// The tables of a list; none where it is absent.
  std::vector<Section> list(std::string_view name);
  /// The tables whose names the user chose, beside their names.
  std::vector<std::pair<std::string, Section>> named();

  TomlNode& node() const { return table_; }
  const Origin& origin() const { return table_.origin; }
  Faults& faults() const { return faults_; }
  /// Of a key that may be absent.
  Origin origin(std::string_view name) const;

  /// A problem of a key: with its value where it is there.
  void fault(std::string_view name, const std::string& problem);
  /// A problem of the whole table.
  void fault(const std::string& problem);
  /// A fault if the key is there: it has no effect, and why.
  void unused(std::string_view name, const std::string& why);

 private:
  std::string child_path(std::string_view name) const;
  [[noreturn]] void fail_without(std::string_view name) const;

  TomlNode& table_;
  std::string path_;
  Faults& faults_;
  std::vector<std::unique_ptr<TomlNode>> stand_ins_;  ///< defaults in the place of faulty values
};

}  // namespace etendue
