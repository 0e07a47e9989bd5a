// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/study_plot.h"

#include <unistd.h>

#include <array>

#include "base/child_process.h"

namespace etendue {
namespace {

constexpr const char* python = "/usr/bin/python3";
constexpr const char* script = ETENDUE_SCRIPTS "/draw";

}  // namespace

std::string draw_study(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(script)) return std::string(script) + " is not there";
  const std::string picture = (folder / "study.svg").string();
  std::string last_line;
  const ChildOutcome child = run_in_child(
      [&](std::FILE*) {
        const std::array<const char*, 7> arguments = {python,     script,          "study", folder.c_str(),
                                                      "--output", picture.c_str(), nullptr};
        execv(python, const_cast<char* const*>(arguments.data()));
        return 1;
      },
      [&](std::string_view line) { last_line = line; });
  if (child.signal == 0 && child.exit_code == 0) return "";
  return last_line.empty() ? std::string(python) + " did not draw it" : last_line;
}

}  // namespace etendue
