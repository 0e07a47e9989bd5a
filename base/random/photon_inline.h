// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// For all that the kernel file uses, which is compiled once for each instruction set: everything has internal
// linkage, so that the linker cannot hand one file's wide code to another's narrow machine.
#define ETENDUE_PHOTON_INLINE static inline __attribute__((always_inline))
#define ETENDUE_PHOTON_MEMBER inline __attribute__((always_inline))
