// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "app/case/keys/section.h"

namespace etendue {

/// The text of a key that begins the names of files among the results; empty where it is absent. A fault
/// where it cannot: with a slash or a control character, with a point in front, or longer than 200 bytes.
std::string file_name(Section& section, std::string_view key);

}  // namespace etendue
