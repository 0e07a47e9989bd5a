// SPDX-License-Identifier: AGPL-3.0-or-later
#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>

#include "base/array_bytes.h"
#include "base/text/text_lines.h"
#include "mesh/files/vtk/raw_mesh_bytes.h"
#include "mesh/files/vtk/refused_file.h"
#include "mesh/files/vtk/vtk_child.h"
#include "mesh/files/vtk/vtu_file.h"
#include "mesh/files/vtk/vtu_grid.h"

namespace etendue {
namespace {

/// zlib at its best makes a byte of 1032; a point takes 12 bytes and a cell more, before.
constexpr double kMostThingsPerByte = 1032.0 / 12;
constexpr std::size_t longest_shown_count = 40;

void check_counts(const std::filesystem::path& path, std::string_view header, const std::string& key,
                  std::size_t size) {
  const std::string opening = key + "=\"";
  for (auto at = header.find(opening); at != std::string_view::npos; at = header.find(opening, at)) {
    at += opening.size();
    const std::string_view text = header.substr(at, header.find('"', at) - at);
    const std::string shown = key + " = " + std::string(text.substr(0, longest_shown_count));
    double count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || !(count >= 0))
      refuse_file(path, shown + ": is not a count");
    if (count > kMostThingsPerByte * static_cast<double>(size))
      refuse_file(path, shown + ": is more than the file holds (is it cut short?)");
  }
}

/// What VTK would not refuse, or only after it took all memory.
void check_header(const std::filesystem::path& path) {
  const std::string bytes = read_bytes(path);
  const std::string_view header = std::string_view(bytes).substr(0, bytes.find("<AppendedData"));
  if (header.empty()) refuse_file(path, "the file is empty");
  if (header.find("<VTKFile") == std::string_view::npos)
    refuse_file(path, "is not a VTK XML file (no <VTKFile> in it)");
  if (header.find("UnstructuredGrid") == std::string_view::npos)
    refuse_file(path, "holds no UnstructuredGrid; save the mesh as one");
  for (const char* key : {"NumberOfPoints", "NumberOfCells"}) check_counts(path, header, key, bytes.size());
}

}  // namespace

std::variant<RawMesh, PolyhedralMesh> read_vtu_file(const std::filesystem::path& path) {
  check_header(path);
  const std::string bytes = read_in_child(path, [&](std::FILE* file) {
    const std::variant<RawMesh, PolyhedralMesh> mesh = read_vtu_grid(path);
    write_array(file, std::vector<std::size_t>{mesh.index()});
    if (const auto* tetrahedra = std::get_if<RawMesh>(&mesh)) write_raw_mesh(file, *tetrahedra);
    if (const auto* polyhedra = std::get_if<PolyhedralMesh>(&mesh)) write_polyhedral_mesh(file, *polyhedra);
  });
  std::string_view rest = bytes;
  const auto named = [&](auto mesh) {
    mesh.file = path.string();
    return mesh;
  };
  if (take_array<std::size_t>(rest).at(0) == 0) return named(take_raw_mesh(rest));
  return named(take_polyhedral_mesh(rest));
}

}  // namespace etendue
