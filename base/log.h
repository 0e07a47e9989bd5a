// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace etendue {

/// Takes one line of what a long computation has to say. May be empty: then nothing is said.
using Log = std::function<void(std::string_view)>;

}  // namespace etendue
