// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "app/case/keys/keys.h"

namespace etendue {

/// The keys that are declared for one table of the case file, in the order of the reference page.
class KeyTable {
 public:
  explicit KeyTable(std::string_view path) : path_(path) {}

  /// Declares a key whose value its reader takes from the section.
  void key(std::string_view name, KeyType type, KeyDetails details, std::string_view help) {
    declarations_.emplace_back(path_, name, type, std::move(details), help);
  }

  const std::vector<KeyDeclaration>& declarations() const { return declarations_; }

 private:
  std::string_view path_;
  std::vector<KeyDeclaration> declarations_;
};

/// The declarations of several tables, one after another.
std::vector<KeyDeclaration> declarations_of(std::initializer_list<KeyTable> tables);

// The keys of the case file by the part of the case that they describe.
std::vector<KeyDeclaration> scene_keys();    ///< units, geometry, bands
std::vector<KeyDeclaration> matter_keys();   ///< media and phase functions
std::vector<KeyDeclaration> light_keys();    ///< walls and lights
std::vector<KeyDeclaration> run_keys();      ///< directions, solution, what to report
std::vector<KeyDeclaration> picture_keys();  ///< cameras
std::vector<KeyDeclaration> sensor_keys();   ///< sensors

namespace key_range {

inline constexpr Need required = Need::required;
inline constexpr double largest_count = 1e9;       // fits an int
inline constexpr double largest_histories = 1e15;  // a double counts them exactly
inline constexpr Range positive{.lowest = 0, .lowest_excluded = true};
inline constexpr Range not_negative{.lowest = 0};
inline constexpr Range fraction{.lowest = 0, .highest = 1};
inline constexpr Range open_fraction{
    .lowest = 0, .highest = 1, .lowest_excluded = true, .highest_excluded = true};
inline constexpr Range asymmetry{
    .lowest = -1, .highest = 1, .lowest_excluded = true, .highest_excluded = true};

}  // namespace key_range

}  // namespace etendue
