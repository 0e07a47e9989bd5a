// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue::test {

/// The unit cube in six tetrahedra; regions "low" and "high", walls "floor" (z = 0) and "sides".
RawMesh cube_of_six();

/// A case, problem and solution on cube_of_six() with made-up values: everything that the writers need,
/// without a solver.
class SampleRun {
 public:
  explicit SampleRun(std::vector<std::string> bands, std::vector<double> edges = {});
  SampleRun(const SampleRun&) = delete;
  SampleRun& operator=(const SampleRun&) = delete;

  /// Looks into this object.
  RunResult result() const;

  Case input;
  TetrahedralMesh mesh;
  Problem problem;
  Solution solution;
  std::vector<ProbeRow> probes;
};

/// A directory for one test, new and empty, removed with all that is in it.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  /// Sorted names of all that is in a directory, hidden files too.
  static std::vector<std::string> names_in(const std::filesystem::path& directory);

 private:
  std::filesystem::path path_;
};

std::string text_of(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);
/// Changes the process in summary.json, as if another process had written these results.
void make_of_another_process(const std::filesystem::path& directory);

}  // namespace etendue::test
