// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>

namespace etendue {

/// What a child process may take at most.
struct ChildLimits {
  double seconds = 0;     ///< [s] of the processor, at least one
  std::size_t bytes = 0;  ///< of memory, beside that of this process
};

/// Limits that grow with the input: of polygons, or of bytes of a file.
ChildLimits limits_for_polygons(std::size_t polygons);
ChildLimits limits_for_file(std::size_t bytes);

/// Runs work in a child process, within limits, and returns the bytes that the work wrote. Throws
/// std::invalid_argument with what the work said against its input (by throwing std::invalid_argument), or
/// that it broke down or exceeded a limit. `library` names what does the work, for messages.
std::string bytes_of_child(const std::string& library, const ChildLimits& limits,
                           const std::function<void(std::FILE* result)>& work);

}  // namespace etendue
