// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "base/content_hash.h"
#include "solver/materials/media/sampled_field.h"

namespace etendue {
namespace {

std::string hash_text(const ContentHash& hash) { return fmt::format("{:016x}", hash.value()); }

/// Tables that the answer does not depend on; "" is what stands above the first, the title. The mesh has a
/// hash of its own, however it came about.
constexpr std::array<std::string_view, 8> free_tables = {"",     "mesh",   "solve",  "probe",
                                                         "time", "output", "camera", "sensor"};

/// Keys of other tables that it does not depend on: a solution with negative values is a good start for one
/// without, and photometric units are those of what sensors say of it.
struct FreeKey {
  std::string_view table, key;
};
constexpr std::array<FreeKey, 9> free_keys = {{{"media", "initial_temperature"},
                                               {"walls", "initial_temperature"},
                                               {"space", "positivity"},
                                               {"units", "illuminance"},
                                               {"units", "luminous_exitance"},
                                               {"units", "luminance"},
                                               {"units", "luminous_flux"},
                                               {"units", "luminous_intensity"},
                                               {"units", "luminous_energy"}}};

bool is_free(std::string_view table, std::string_view line) {
  return std::ranges::any_of(free_keys, [&](const FreeKey& free) {
    return free.table == table && line.starts_with(free.key) &&
           line.substr(free.key.size()).starts_with(" = ");
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
    if (!line.empty() && !is_free(name, line)) table += line + "\n";
  }
  end_table();
  return tables;
}

/// Fields are the only functions that formulas take from files.
void add_fields(const BandValues& values, ContentHash& hash) {
  for (const Value& value : values.values)
    if (const auto* formula = std::get_if<Formula>(&value))
      for (const auto& [name, function] : formula->functions)
        if (const auto* field = dynamic_cast<const SampledField*>(function.get())) hash.add(field->content());
}

void add_curve(const TemperatureCurve& curve, ContentHash& hash) {
  if (const auto* table = std::get_if<TemperatureCurve::Table>(&curve.form()))
    for (const auto* numbers : {&table->kelvin, &table->values})
      for (const double number : *numbers) hash.add(number);
  if (const auto* polynomial = std::get_if<TemperatureCurve::Polynomial>(&curve.form()))
    for (const double term : polynomial->terms) hash.add(term);
}

/// What files hold that tables of this name take numbers from: the text of the case has their names alone.
void add_files_of_table(const Case& input, const std::string& table, ContentHash& hash) {
  if (table == "bands")
    for (const GrayGas& gas : input.bands.gas.gases) {
      add_curve(gas.absorption, hash);
      add_curve(gas.weight, hash);
    }
  if (table == "bands" && input.molar_ratio) add_fields(*input.molar_ratio, hash);
  if (table == "media")
    for (const auto& [name, medium] : input.media)
      for (const auto* values :
           {&medium.absorption, &medium.scattering, &medium.extinction, &medium.albedo, &medium.emission,
            &medium.power_density, &medium.temperature, &medium.heat_source, &medium.conductivity,
            &medium.heat_capacity, &medium.initial_temperature})
        if (*values) add_fields(**values, hash);
  if (table == "walls")
    for (const auto& [name, wall] : input.walls) {
      add_fields(wall.radiance, hash);
      for (const auto* values : {&wall.heat_capacity, &wall.initial_temperature})
        if (*values) add_fields(**values, hash);
    }
  if (table == "light")
    for (const LightCase& light : input.lights)
      for (const auto* numbers : {&light.angle, &light.intensity, &light.plane})
        for (const double number : *numbers) hash.add(number);
}

}  // namespace

std::string mesh_hash(const TetrahedralMesh& mesh) {
  ContentHash hash;
  for (const Vec3& point : mesh.points())
    for (const double coordinate : point) hash.add(coordinate);
  for (const auto& cell : mesh.cell_vertices())
    for (const std::int32_t vertex : cell) hash.add(vertex);
  for (const std::int32_t region : mesh.cell_regions()) hash.add(region);
  for (const std::int32_t wall : mesh.face_walls()) hash.add(wall);
  for (const std::string& name : mesh.region_names()) hash.add(name);
  for (const std::string& name : mesh.wall_names()) hash.add(name);
  return hash_text(hash);
}

std::vector<CasePart> case_parts(const Case& input) {
  std::vector<CasePart> parts;
  for (const auto& [name, tables] : tables_of(input.resolved_toml)) {
    if (std::count(free_tables.begin(), free_tables.end(), name) > 0) continue;
    ContentHash hash;
    for (const std::string& table : tables) hash.add(table);
    add_files_of_table(input, name, hash);
    parts.push_back({name, hash_text(hash)});
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
