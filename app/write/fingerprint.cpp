// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

namespace etendue {
namespace {

/// FNV-1a (Fowler, Noll and Vo 1991) in 64 bits: for telling apart by accident, not by intent.
class Hash {
 public:
  void add(std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<std::uint8_t>(value >> shift));
  }
  void add(std::int32_t value) { add(static_cast<std::uint64_t>(value)); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    for (const char c : text) add_byte(static_cast<std::uint8_t>(c));
  }
  std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3; }

  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Tables that the answer does not depend on; "" is what stands above the first, the title. The mesh has a
/// hash of its own, however it came about.
constexpr std::array<std::string_view, 7> free_tables = {"",       "mesh",   "solve", "probe",
                                                         "output", "camera", "sensor"};

/// Keys of other tables that it does not depend on: a solution with negative values is a good start for one
/// without, and photometric units are those of what sensors say of it.
constexpr std::array<std::string_view, 7> free_keys = {
    "positivity",    "illuminance",        "luminous_exitance", "luminance",
    "luminous_flux", "luminous_intensity", "luminous_energy"};

bool is_free(std::string_view line) {
  return std::ranges::any_of(free_keys, [&](std::string_view key) {
    return line.starts_with(key) && line.substr(key.size()).starts_with(" = ");
  });
}

/// The first word of a line that opens a table: [media.smoke], [[probe]].
std::string table_of(const std::string& header) {
  const auto first = header.find_first_not_of('[');
  return header.substr(first, header.find_first_of(".]", first) - first);
}

/// The tables of the resolved case by their first words, in any order of the file.
std::map<std::string, std::multiset<std::string>> tables_of(const std::string& resolved) {
  std::map<std::string, std::multiset<std::string>> tables;
  std::string name, table, line;
  const auto end_table = [&] { tables[name].insert(std::exchange(table, {})); };
  for (std::istringstream stream(resolved); std::getline(stream, line);) {
    if (line.starts_with('[')) {
      end_table();
      name = table_of(line);
    }
    if (!line.empty() && !is_free(line)) table += line + "\n";
  }
  end_table();
  return tables;
}

}  // namespace

std::string mesh_hash(const TetrahedralMesh& mesh) {
  Hash hash;
  for (const Vec3& point : mesh.points())
    for (const double coordinate : point) hash.add(coordinate);
  for (const auto& cell : mesh.cell_vertices())
    for (const std::int32_t vertex : cell) hash.add(vertex);
  for (const std::int32_t region : mesh.cell_regions()) hash.add(region);
  for (const std::int32_t wall : mesh.face_walls()) hash.add(wall);
  for (const std::string& name : mesh.region_names()) hash.add(name);
  for (const std::string& name : mesh.wall_names()) hash.add(name);
  return hash.text();
}

std::vector<CasePart> case_parts(const Case& input) {
  std::vector<CasePart> parts;
  for (const auto& [name, tables] : tables_of(input.resolved_toml)) {
    if (std::count(free_tables.begin(), free_tables.end(), name) > 0) continue;
    Hash hash;
    for (const std::string& table : tables) hash.add(table);
    parts.push_back({name, hash.text()});
  }
  return parts;
}

std::vector<std::string> different_parts(const std::vector<CasePart>& a, const std::vector<CasePart>& b) {
  std::set<std::string> names;
  const auto add_missing = [&](const std::vector<CasePart>& from, const std::vector<CasePart>& in) {
    for (const CasePart& part : from)
      if (std::count(in.begin(), in.end(), part) == 0) names.insert(part.name);
  };
  add_missing(a, b);
  add_missing(b, a);
  return {names.begin(), names.end()};
}

}  // namespace etendue
