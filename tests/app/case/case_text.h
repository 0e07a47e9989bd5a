// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/case/case.h"

namespace etendue {

/// A folder of its own for one test, removed with its files at the end.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Writes a file here.
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

// Inline, so that they are made before the strings of the tests that begin with them.

/// Six lines: a unit cube of air, and entries for all media and walls.
inline const std::string cube = R"([[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [1, 1, 1]
[media."*"]
[walls."*"]
)";

/// Two lines: entries for all media and walls, without a geometry.
inline const std::string no_geometry = R"([media."*"]
[walls."*"]
)";

/// The case of this text.
Case case_of(const std::string& text, const Overrides& overrides = {});

/// What is wrong with a file `slab.toml` of this text, a line each; empty if nothing is.
std::string faults_of(const std::string& text, const Overrides& overrides = {});

}  // namespace etendue
