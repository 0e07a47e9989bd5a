// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace etendue {

/// JSON Schema (draft 7) of the case file, by which editors complete keys, show what they mean and mark what
/// is wrong. It accepts all that the reader accepts; what depends on several keys is found by the reader
/// alone.
std::string key_schema();

}  // namespace etendue
