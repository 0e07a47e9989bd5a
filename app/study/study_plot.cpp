// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/study_plot.h"

#include <unistd.h>

#include <array>

#include "app/write/result/output_folder.h"
#include "base/child_process.h"

namespace etendue {
namespace {

constexpr const char* python = "/usr/bin/python3";

/// scripts/draw of the checkout that the program was built in: in the first directory above the program that
/// has it. The program holds no path of the checkout, so that it is the same wherever it is built.
std::filesystem::path drawing_script() {
  std::error_code unknown;
  std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
  for (; folder.has_relative_path(); folder = folder.parent_path())
    if (std::filesystem::exists(folder / "scripts" / "draw", unknown)) return folder / "scripts" / "draw";
  return {};
}

}  // namespace

std::string draw_study(const std::filesystem::path& folder) {
  const std::filesystem::path script = drawing_script();
  if (script.empty()) return "scripts/draw is in no directory above the program";
  OutputFolder files(folder);
  const std::string picture = files.add("study.svg").string();
  std::string last_line;
  const ChildOutcome child = run_in_child(
      [&](std::FILE*) {
        const std::array<const char*, 7> arguments = {python,     script.c_str(),  "study", folder.c_str(),
                                                      "--output", picture.c_str(), nullptr};
        execv(python, const_cast<char* const*>(arguments.data()));
        return 1;
      },
      [&](std::string_view line) { last_line = line; });
  if (child.signal == 0 && child.exit_code == 0) {
    files.publish({});
    return "";
  }
  return last_line.empty() ? std::string(python) + " did not draw it" : last_line;
}

}  // namespace etendue
