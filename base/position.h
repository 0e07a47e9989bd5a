// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

namespace etendue {

/// A number of a thing as its place in an array.
constexpr std::size_t position(int number) { return static_cast<std::size_t>(number); }

}  // namespace etendue
