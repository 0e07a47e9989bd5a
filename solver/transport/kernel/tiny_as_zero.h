// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/transport/kernel/kernel_inline.h"

// For the kernel files only.
namespace etendue {
namespace {

/// While it lives, floats too small for their full precision (below 1.2e-38) count as zero: behind a hundred
/// mean free paths there is nothing else, and each operation on them costs a hundred others. Doubles are left
/// as they are.
template <class Number>
class TinyAsZero {};

#ifdef __SSE__
template <>
class TinyAsZero<float> {
 public:
  ETENDUE_KERNEL_MEMBER TinyAsZero() : before_(__builtin_ia32_stmxcsr()) {
    __builtin_ia32_ldmxcsr(before_ | flush_to_zero | denormals_are_zero);
  }
  ETENDUE_KERNEL_MEMBER ~TinyAsZero() { __builtin_ia32_ldmxcsr(before_); }
  TinyAsZero(const TinyAsZero&) = delete;
  TinyAsZero& operator=(const TinyAsZero&) = delete;

 private:
  static constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  unsigned before_;
};
#endif

}  // namespace
}  // namespace etendue
