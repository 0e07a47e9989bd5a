// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <vector>

namespace etendue {

// Arrays on their way from a child process to this one: the number of values, then the values.

template <class T>
void write_array(std::FILE* file, const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::size_t count = values.size();
  if (std::fwrite(&count, sizeof count, 1, file) != 1 ||
      (count > 0 && std::fwrite(values.data(), sizeof(T), count, file) != count))
    throw std::runtime_error("cannot write a temporary file (is the disk full?)");
}

/// Takes the first array off the bytes.
template <class T>
std::vector<T> take_array(std::string_view& bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::size_t count = 0;
  if (bytes.size() < sizeof count) throw std::runtime_error("a temporary file is cut short");
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  if (bytes.size() / sizeof(T) < count) throw std::runtime_error("a temporary file is cut short");
  std::vector<T> values(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return values;
}

/// Takes an array of one value off the bytes.
template <class T>
T take_value(std::string_view& bytes) {
  const std::vector<T> values = take_array<T>(bytes);
  if (values.empty()) throw std::runtime_error("a temporary file is cut short");
  return values.front();
}

}  // namespace etendue
