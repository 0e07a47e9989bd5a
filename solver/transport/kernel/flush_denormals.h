// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/transport/kernel/kernel_inline.h"

// For the kernel files only.
namespace etendue {
namespace {

/// Flushes denormal floats (below 1.2e-38) to zero during its lifetime. Behind a hundred mean free paths all
/// values are denormal, and an operation on one costs as much as a hundred others. Doubles stay unchanged.
template <class Number>
class FlushDenormals {};

#ifdef __SSE__
template <>
class FlushDenormals<float> {
 public:
  ETENDUE_KERNEL_MEMBER FlushDenormals() : before_(__builtin_ia32_stmxcsr()) {
    __builtin_ia32_ldmxcsr(before_ | flush_to_zero | denormals_are_zero);
  }
  ETENDUE_KERNEL_MEMBER ~FlushDenormals() { __builtin_ia32_ldmxcsr(before_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  static constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  unsigned before_;
};
#endif

}  // namespace
}  // namespace etendue
