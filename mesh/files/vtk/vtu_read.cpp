// SPDX-License-Identifier: AGPL-3.0-or-later
#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>

#include "base/child_process.h"
#include "base/errors.h"
#include "base/text_lines.h"
#include "mesh/files/vtk/raw_mesh_bytes.h"
#include "mesh/files/vtk/vtk_threads.h"
#include "mesh/files/vtk/vtu_file.h"
#include "mesh/files/vtk/vtu_grid.h"

namespace etendue {
namespace {

/// zlib at its best makes a byte of 1032; a point takes 12 bytes and a cell more, before.
constexpr double kMostThingsPerByte = 1032.0 / 12;
constexpr std::size_t kLongestShown = 40;
constexpr int kRejected = 64;  // exit code of the child process; it leaves the problem as its result

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& problem) {
  throw InputError(Fault{path.string(), 0, problem});
}

void check_counts(const std::filesystem::path& path, std::string_view header, const std::string& key,
                  std::size_t size) {
  const std::string opening = key + "=\"";
  for (auto at = header.find(opening); at != std::string_view::npos; at = header.find(opening, at)) {
    at += opening.size();
    const std::string_view text = header.substr(at, header.find('"', at) - at);
    const std::string shown = key + " = " + std::string(text.substr(0, kLongestShown));
    double count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || !(count >= 0))
      fail(path, shown + ": is not a count");
    if (count > kMostThingsPerByte * static_cast<double>(size))
      fail(path, shown + ": is more than the file holds (is it cut short?)");
  }
}

/// What VTK would not refuse, or only after it took all memory.
void check_header(const std::filesystem::path& path) {
  const std::string bytes = read_bytes(path);
  const std::string_view header = std::string_view(bytes).substr(0, bytes.find("<AppendedData"));
  if (header.empty()) fail(path, "the file is empty");
  if (header.find("<VTKFile") == std::string_view::npos)
    fail(path, "is not a VTK XML file (no <VTKFile> in it)");
  if (header.find("UnstructuredGrid") == std::string_view::npos)
    fail(path, "holds no UnstructuredGrid; save the mesh as one");
  for (const char* key : {"NumberOfPoints", "NumberOfCells"}) check_counts(path, header, key, bytes.size());
}

int read_to_file(const std::filesystem::path& path, std::FILE* file) try {
  use_vtk_without_threads();
  write_raw_mesh(file, read_vtu_grid(path));
  return 0;
} catch (const InputError& error) {
  std::fputs(error.faults().front().text.c_str(), file);
  return kRejected;
}

}  // namespace

RawMesh read_vtu_file(const std::filesystem::path& path) {
  check_header(path);
  const ChildOutcome child =
      run_in_child([&](std::FILE* file) { return read_to_file(path, file); }, {}, memory_to_read(path));
  if (child.signal == 0 && child.exit_code == kRejected) fail(path, child.result);
  if (child.signal != 0 || child.exit_code != 0) fail(path, "VTK breaks down on it; is it corrupt?");
  RawMesh mesh = take_raw_mesh(child.result);
  mesh.file = path.string();
  return mesh;
}

}  // namespace etendue
