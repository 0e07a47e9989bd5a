// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#include "base/errors.h"

namespace etendue {

/// Returns whether this machine has "baseline", "avx2" (x86-64-v3) or "avx512" (x86-64-v4).
inline bool has_instruction_set(std::string_view name) {
#ifdef __x86_64__
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (name == "avx2") return v3;
  if (name == "avx512")
    return v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512cd");
#endif
  return name == "baseline";
}

/// Place of the first of the instruction sets that kernels are built for, best first, that this machine
/// has, or of the one that the environment variable ETENDUE_ISA names. Throws InputError where that is not
/// built or not there.
inline std::size_t choose_instruction_set(std::span<const std::string_view> built) {
  const char* wanted = std::getenv("ETENDUE_ISA");
  std::string known;
  for (std::size_t i = 0; i < built.size(); ++i) {
    known += (i == 0 ? "" : i + 1 < built.size() ? ", " : " or ") + std::string(built[i]);
    if (wanted != nullptr && built[i] != wanted) continue;
    if (has_instruction_set(built[i])) return i;
    if (wanted != nullptr)
      throw InputError(std::string("ETENDUE_ISA = ") + wanted + ": this machine does not have it");
  }
  throw InputError(std::string("ETENDUE_ISA = ") + (wanted != nullptr ? wanted : "") + ": unknown; use " +
                   known);
}

}  // namespace etendue
