// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace etendue {

/// Description of one table, or of one key, of the case file as plain text of at most 100 columns. The path
/// is that of a table ("mesh.box", "walls.floor"), of a key ("solve.tolerance", "walls.floor.diffuse"), or
/// the name of a key in any table ("diffuse"). Throws InputError where there is none, with the name nearest
/// to it.
std::string key_help(std::string_view path);

}  // namespace etendue
