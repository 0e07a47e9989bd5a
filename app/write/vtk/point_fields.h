// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// An array on points.
struct PointField {
  std::string name;
  std::string unit;
  std::vector<double> values;  ///< [cell][4][band]
  bool by_bands = true;        ///< else [cell][4]
};

/// A file of every cell with four points of its own, its region and arrays on the points. `path` is written,
/// `shown` is named in a FileError.
void write_point_fields(const RunResult& result, const std::vector<PointField>& fields,
                        const std::filesystem::path& path, const std::filesystem::path& shown);

}  // namespace etendue
