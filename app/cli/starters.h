// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace etendue {

/// A commented case to begin with.
struct Starter {
  std::string_view name;
  std::string_view text;  ///< TOML
};

/// The files of app/cli/starters, built into the program.
std::span<const Starter> starters();

}  // namespace etendue
