// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// For all that the kernel files use, which are compiled once for each instruction set: everything has
// internal linkage, so that the linker cannot hand one file's wide code to another's narrow machine.
#define ETENDUE_KERNEL_INLINE static inline __attribute__((always_inline))
#define ETENDUE_KERNEL_MEMBER inline __attribute__((always_inline))

// Loops over the cells of a packet, nodes and faces: unrolled, so that their arrays stay in registers.
#define ETENDUE_UNROLL _Pragma("GCC unroll 8")
