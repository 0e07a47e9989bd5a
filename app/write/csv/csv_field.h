// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace etendue {

/// A text field as RFC 4180 has it: quoted where it holds a comma, a quote or a line break.
std::string csv_field(const std::string& text);

}  // namespace etendue
