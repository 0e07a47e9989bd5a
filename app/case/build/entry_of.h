// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace etendue {

/// The entry of a name, else that of "*". An empty one for names in the mesh's list that nothing carries.
template <class Entry>
Entry entry_of(const std::map<std::string, Entry>& entries, const std::string& name) {
  for (const std::string& key : {name, std::string("*")})
    if (const auto found = entries.find(key); found != entries.end()) return found->second;
  return {};
}

}  // namespace etendue
