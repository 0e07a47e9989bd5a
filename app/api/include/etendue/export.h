// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

/// Marks the interface.
#define ETENDUE_EXPORT __attribute__((visibility("default")))

// The version of the interface is part of the name of every symbol. Users need not write it. Sources of the
// library do: they have other classes of the same names beside these.
#ifdef ETENDUE_IMPLEMENTATION
#define ETENDUE_INTERFACE_BEGIN namespace v0 {
#else
#define ETENDUE_INTERFACE_BEGIN inline namespace v0 {
#endif
#define ETENDUE_INTERFACE_END }
