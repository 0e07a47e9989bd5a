// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace etendue {

/// The columns of a CSV file of numbers, which has as many on each line as `names`; what follows # is a
/// comment, and the first line may name the columns. Throws FileError where it cannot be read, InputError
/// with the line where it is not such a file.
std::vector<std::vector<double>> read_columns(const std::filesystem::path& path,
                                              const std::vector<std::string>& names);

}  // namespace etendue
