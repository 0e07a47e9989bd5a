// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string_view>

#include "base/field_data.h"

namespace etendue {

// The data of a field on their way from a child process to this one.
void write_field_data(std::FILE* file, const FieldData& field);
FieldData take_field_data(std::string_view bytes);

}  // namespace etendue
