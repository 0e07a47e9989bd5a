// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// The text of summary.json; `files` are all names of the run, its own included.
std::string summary_json(const RunResult& result, const std::vector<std::string>& files,
                         double seconds_writing);

/// The names that the summary.json of an earlier run in this directory lists; empty where there is none, or
/// where it is not ours. Those in a folder of the directory, or in none.
std::vector<std::string> files_of_earlier_run(const std::filesystem::path& directory,
                                              const std::string& folder = "");

/// The text of the summary.json in this directory with more names among its files, and with the seconds of
/// the run's pictures where they are given; empty where there is none.
std::string summary_with_files(const std::filesystem::path& directory, const std::vector<std::string>& more,
                               std::optional<double> seconds_of_pictures = {});

/// The text of the summary.json in this directory with an estimate of the run's errors, a JSON object, the
/// seconds that it took and the file estimate.csv; empty where there is none.
std::string summary_with_estimate(const std::filesystem::path& directory, const std::string& estimate,
                                  double seconds);

/// The same with how it came to its accuracy, a JSON object, and the file accuracy.csv.
std::string summary_with_accuracy(const std::filesystem::path& directory, const std::string& accuracy);

/// Whether the summary.json in this directory is of a run by another process: files of two runs do not belong
/// into one directory.
bool holds_other_run(const std::filesystem::path& directory);

/// The case that a summary.json holds, resolved, and the file that it was read from; empty where there is
/// none.
struct SavedCase {
  std::string toml;
  std::filesystem::path file;
};
std::optional<SavedCase> case_of_earlier_run(const std::filesystem::path& directory);

/// The most memory that this process had at a time [bytes].
long peak_memory();
/// Lets the peak begin at what is taken now, where the system can (Linux, proc(5): clear_refs).
void restart_peak_memory();

}  // namespace etendue
