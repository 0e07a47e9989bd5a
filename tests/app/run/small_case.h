// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "tests/app/write/sample_run.h"

namespace etendue::test {

/// Whether a text has a part.
inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A unit cube of smoke with an emitting floor, three bands, 8 directions and a probe: solved in a moment.
std::string small_case();

/// What the program said and returned.
struct Outcome {
  ExitCode code;
  std::string out;
  std::string err;
};

/// Runs the program in this process; a run estimates no errors unless it is asked to, for the time.
Outcome etendue_says(const std::vector<std::string>& arguments);

/// A scratch folder with case.toml in it.
class CaseFolder : public ScratchFolder {
 public:
  explicit CaseFolder(const std::string& text = small_case());
  std::string file() const { return (path() / "case.toml").string(); }
  std::string results() const { return (path() / "results").string(); }
};

}  // namespace etendue::test
