// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/fields/field_file.h"

#include <cstdio>
#include <fstream>

#include "base/child_process.h"
#include "base/errors.h"
#include "mesh/files/fields/field_data_bytes.h"
#include "mesh/files/fields/field_grid.h"
#include "mesh/files/vtk/vtk_threads.h"

namespace etendue {
namespace {

constexpr int kRejected = 64;  // exit code of the child process; it leaves the problem as its result

int read_to_file(const FieldRequest& request, std::FILE* file) try {
  use_vtk_without_threads();
  write_field_data(file, read_field_by_vtk(request));
  return 0;
} catch (const InputError& error) {
  std::fputs(error.faults().front().text.c_str(), file);
  return kRejected;
}

}  // namespace

FieldData read_field(const FieldRequest& request) {
  if (!std::filesystem::is_directory(request.path) && !std::ifstream(request.path))
    throw FileError(request.path.string(), "cannot be opened");
  const ChildOutcome child = run_in_child([&](std::FILE* file) { return read_to_file(request, file); }, {},
                                          memory_to_read(request.path));
  const auto fail = [&request](const std::string& problem) {
    throw InputError(Fault{request.path.string(), 0, problem});
  };
  if (child.signal == 0 && child.exit_code == kRejected) fail(child.result);
  if (child.signal != 0 || child.exit_code != 0) fail("VTK breaks down on it; is it corrupt?");
  return take_field_data(child.result);
}

}  // namespace etendue
