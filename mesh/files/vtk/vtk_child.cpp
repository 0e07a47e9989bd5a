// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/vtk_child.h"

#include "base/child_process.h"
#include "base/errors.h"
#include "mesh/files/vtk/refused_file.h"
#include "mesh/files/vtk/vtk_threads.h"

namespace etendue {
namespace {

constexpr int rejected = 64;  // exit code of the child process; it leaves the problem as its result

int read_to_file(const std::function<void(std::FILE*)>& read, std::FILE* file) try {
  use_vtk_without_threads();
  read(file);
  return 0;
} catch (const InputError& error) {
  std::fputs(error.faults().front().text.c_str(), file);
  return rejected;
}

}  // namespace

std::string read_in_child(const std::filesystem::path& path, const std::function<void(std::FILE*)>& read) {
  ChildOutcome child =
      run_in_child([&](std::FILE* file) { return read_to_file(read, file); }, {}, memory_to_read(path));
  if (child.signal == 0 && child.exit_code == rejected) refuse_file(path, child.result);
  if (child.signal != 0 || child.exit_code != 0) refuse_file(path, "VTK breaks down on it; is it corrupt?");
  return std::move(child.result);
}

}  // namespace etendue
