// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace etendue {

/// Numbers names in the order in which they are first met.
class NameTable {
 public:
  int index(const std::string& name) {
    const auto [entry, is_new] = indices_.emplace(name, static_cast<int>(names_.size()));
    if (is_new) names_.push_back(name);
    return entry->second;
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::unordered_map<std::string, int> indices_;
  std::vector<std::string> names_;
};

}  // namespace etendue
