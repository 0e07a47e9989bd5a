// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// An array of a file that is made of fluences.
struct FluenceField {
  std::string name;
  std::string unit;
  std::vector<double> values;  ///< [cell][4][band]
};

/// A file of every cell with four points of its own, its region and arrays on the points. `path` is written,
/// `shown` is named in a FileError.
void write_fluence_fields(const RunResult& result, const std::vector<FluenceField>& fields,
                          const std::filesystem::path& path, const std::filesystem::path& shown);

}  // namespace etendue
