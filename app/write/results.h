// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// What was written, and how long that took.
struct WrittenResults {
  std::filesystem::path directory;
  std::vector<std::string> files;  ///< names in the directory
  double seconds = 0;
};

/// Writes every output of a run into the case's output directory: each file to a temporary name, renamed when
/// all are whole. Files that an earlier run wrote and this one does not are removed; others stay.
/// Throws FileError, and then no file has changed.
WrittenResults write_results(const RunResult& result);

}  // namespace etendue
