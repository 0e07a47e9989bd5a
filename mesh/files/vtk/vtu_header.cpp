// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/vtu_header.h"

#include <charconv>
#include <string>
#include <string_view>

#include "base/text/text_lines.h"
#include "mesh/files/vtk/refused_file.h"

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

}  // namespace

void check_vtu_header(const std::filesystem::path& path) {
  const std::string bytes = read_bytes(path);
  const std::string_view header = std::string_view(bytes).substr(0, bytes.find("<AppendedData"));
  if (header.empty()) refuse_file(path, "the file is empty");
  if (header.find("<VTKFile") == std::string_view::npos)
    refuse_file(path, "is not a VTK XML file (no <VTKFile> in it)");
  if (header.find("UnstructuredGrid") == std::string_view::npos)
    refuse_file(path, "holds no UnstructuredGrid; save the mesh as one");
  for (const char* key : {"NumberOfPoints", "NumberOfCells"}) check_counts(path, header, key, bytes.size());
}

}  // namespace etendue
