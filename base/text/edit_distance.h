// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace etendue {

/// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other
/// (Damerau 1964, in the restricted form that edits no part twice). Capitals count as small letters.
int edit_distance(std::string_view a, std::string_view b);

/// The name that a misspelt one most likely means; empty where none is near.
std::string closest_name(std::string_view misspelt, std::span<const std::string> names);

/// `; did you mean "…"?`, or empty.
std::string suggestion(std::string_view misspelt, std::span<const std::string> names);

/// `a, b or c`.
std::string enumerate(std::span<const std::string> names);

}  // namespace etendue
