// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/study_plot.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <optional>

#include "app/write/result/output_folder.h"
#include "base/child_process.h"

namespace etendue {
namespace {

constexpr const char* python = "/usr/bin/python3";

/// User that a file belongs to; nothing where there is none.
std::optional<uid_t> owner_of(const std::filesystem::path& file) {
  struct stat found {};
  return stat(file.c_str(), &found) == 0 ? std::optional(found.st_uid) : std::nullopt;
}

/// scripts/draw of the checkout whose build folder build/NAME the program is in, where both belong to one
/// user. The program holds no path of the checkout, so that it is the same wherever it is built.
std::filesystem::path drawing_script() {
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  std::filesystem::path folder = program.parent_path();
  while (folder.has_relative_path() && !std::filesystem::exists(folder / "CMakeCache.txt", unknown))
    folder = folder.parent_path();
  const std::filesystem::path script = folder.parent_path().parent_path() / "scripts" / "draw";
  const auto owner = owner_of(script);
  return owner && owner == owner_of(program) ? script : std::filesystem::path();
}

}  // namespace

std::string draw_study(const std::filesystem::path& folder) {
  const std::filesystem::path script = drawing_script();
  if (script.empty()) return "scripts/draw of its checkout is not where the program was built";
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
